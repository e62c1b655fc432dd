// Jolt Physics (its WebAssembly package, in single precision): rays and shape casts against a mesh.
// SPDX-License-Identifier: MIT
import { engine, length, middle, minus, serve, turn, version_of } from "./engine.mjs";

const { default: start } = await engine("jolt-physics");
const Jolt = await start();

const RADIUS = 0.125;
const settings = new Jolt.JoltSettings();
const filter = new Jolt.ObjectLayerPairFilterTable(1);
filter.EnableCollision(0, 0);
const layers = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
layers.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
settings.mObjectLayerPairFilter = filter;
settings.mBroadPhaseLayerInterface = layers;
settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, filter, 1);
const world = new Jolt.JoltInterface(settings).GetPhysicsSystem();
const bodies = world.GetBodyInterface();
const narrow = world.GetNarrowPhaseQuery();
const any = [new Jolt.BroadPhaseLayerFilter(), new Jolt.ObjectLayerFilter(), new Jolt.BodyFilter(),
  new Jolt.ShapeFilter()];

const vector = (p) => new Jolt.Vec3(p[0], p[1], p[2]);
const position = (p) => new Jolt.RVec3(p[0], p[1], p[2]);

/** Calls `use` while a body of this shape stands there. */
function with_body(shape, position, rotation, use) {
  const created = new Jolt.BodyCreationSettings(shape, position, rotation, Jolt.EMotionType_Static, 0);
  const body = bodies.CreateBody(created);
  Jolt.destroy(created);
  bodies.AddBody(body.GetID(), Jolt.EActivation_DontActivate);
  try {
    return use();
  } finally {
    bodies.RemoveBody(body.GetID());
    bodies.DestroyBody(body.GetID());
  }
}

const unturned = new Jolt.Quat(0, 0, 0, 1);

/** A mesh of the query's one face, about its first corner. */
function face(q) {
  const triangles = new Jolt.TriangleList();
  const corners = q.start.slice(1).map((p) => vector(minus(p, q.start[1])));
  const triangle = new Jolt.Triangle(...corners);
  triangles.push_back(triangle);
  const made = new Jolt.MeshShapeSettings(triangles);
  const result = made.Create();
  const shape = result.HasError() ? undefined : result.Get();
  for (const thing of [made, triangle, triangles, ...corners]) Jolt.destroy(thing);
  return shape;
}

const ray_settings = new Jolt.RayCastSettings();
ray_settings.SetBackFaceMode(Jolt.EBackFaceMode_CollideWithBackFaces);

function ray(q) {
  const shape = face(q);
  if (shape === undefined) return undefined;
  return with_body(shape, position(q.start[1]), unturned, () => {
    const hit = new Jolt.CastRayClosestHitCollisionCollector();
    const line = new Jolt.RRayCast(position(q.start[0]), vector(minus(q.end[0], q.start[0])));
    narrow.CastRay(line, ray_settings, hit, ...any);
    const time = hit.HadHit() ? hit.mHit.mFraction : null;
    Jolt.destroy(line);
    Jolt.destroy(hit);
    return time;
  });
}

const cast_settings = new Jolt.ShapeCastSettings();
cast_settings.mBackFaceModeTriangles = Jolt.EBackFaceMode_CollideWithBackFaces;
cast_settings.mBackFaceModeConvex = Jolt.EBackFaceMode_CollideWithBackFaces;
const tolerance = cast_settings.mCollisionTolerance;

/** Casts a shape from a place by a motion against the body that stands there. */
function cast(shape, transform, motion) {
  const hit = new Jolt.CastShapeClosestHitCollisionCollector();
  const one = new Jolt.Vec3(1, 1, 1), direction = vector(motion), base = position([0, 0, 0]);
  const shape_cast = new Jolt.RShapeCast(shape, one, transform, direction);
  narrow.CastShape(shape_cast, cast_settings, base, hit, ...any);
  const time = hit.HadHit() ? hit.mHit.mFraction : null;
  for (const thing of [hit, one, direction, base, shape_cast]) Jolt.destroy(thing);
  return time;
}

function capsule(q, i) {
  const along = minus(q.start[i + 1], q.start[i]);
  return [new Jolt.CapsuleShape(length(along) / 2, RADIUS), new Jolt.Quat(...turn([0, 1, 0], along)),
    position(middle(q.start[i], q.start[i + 1]))];
}

function round(q) {
  const motion = minus(q.end[0], q.start[0]);
  if (q.kind === "edge-edge") {
    const [a, turn_a, at_a] = capsule(q, 0), [b, turn_b, at_b] = capsule(q, 2);
    return with_body(b, at_b, turn_b, () => cast(a, Jolt.RMat44.prototype.sRotationTranslation(turn_a, at_a), motion));
  }
  const shape = face(q);
  if (shape === undefined) return undefined;
  return with_body(shape, position(q.start[1]), unturned, () => cast(new Jolt.SphereShape(2 * RADIUS),
    Jolt.RMat44.prototype.sRotationTranslation(unturned, position(q.start[0])), motion));
}

const common = `engine ${version_of("Jolt Physics", "jolt-physics")}
  numbers float
  elements 0.001
  sizes 0.5 8`;
await serve([
  { name: "ray", ask: ray, lines: `${common}
    asks CastRay against a MeshShape of one triangle, back faces too
    kinds vertex-face
    motion cast
    tolerance-relative 2e-6
    note by its code the corners of a mesh are rounded to 21 bits within its bounds` },
  { name: "round", ask: round, lines: `${common}
    asks CastShape of a capsule against a capsule (radius 0.125), and of a ball (radius 0.25) against a MeshShape
    kinds edge-edge vertex-face
    motion cast
    separation 0.25
    tolerance-length ${tolerance.toPrecision(1)}
    tolerance-relative 1e-5
    note the default settings but for back faces, which count: mCollisionTolerance ${tolerance.toPrecision(1)}` },
]);

using Unity.Collections;
using Unity.Mathematics;

namespace SphFluid.Validation
{
    /// <summary>
    /// The thesis's CollisionForce (6.3.3) per unit mass [m/s²]: Shaders/Solver/Thesis/CollisionForce.hlsl in double precision.
    /// </summary>
    internal struct CpuCollision
    {
        public double3 HalfSize;
        public CpuWallDrag Drag;
        public double TimeStep;
        public double KickStep;      // s: what the acceleration is multiplied by
        public double WallStiffness; // 1/s^2
        public double WallDamping;   // 1/s
        public double WallDistance;  // m: contact begins here
        public double WallReach;     // m: how deep inside a closed mesh a particle is still pushed out
        public int MeshCount;

        [ReadOnly] public NativeArray<CpuTriangle> Triangles;

        [ReadOnly] public NativeArray<CpuMesh> Meshes;

        /// <summary>Domain box and every mesh whose box is within reach of the step.</summary>
        public double3 Force(double3 position, double3 velocity)
        {
            double reach = (Drag.On ? math.max(WallDistance, Drag.Distance) : WallDistance) + math.length(velocity) * TimeStep;
            double3 force = DomainForce(position, velocity);
            double3 drag = Drag.On ? Drag.Domain(position + HalfSize, HalfSize - position, velocity) : double3.zero;
            for (int m = 0; m < MeshCount; m++)
            {
                CpuMesh mesh = Meshes[m];
                double3 low = position - mesh.BoundsMin;
                double3 high = mesh.BoundsMax - position;
                if (math.min(math.min(low.x, low.y), low.z) > -reach && math.min(math.min(high.x, high.y), high.z) > -reach)
                {
                    force += MeshForce(mesh, position, velocity, reach, ref drag);
                }
            }

            return force + drag;
        }

        private double3 WallForce(double3 normal, double distance, double3 velocity)
        {
            return normal * Push(distance, math.dot(velocity, normal));
        }

        // Damped spring that only pushes.
        private double Push(double distance, double speedAway)
        {
            return distance < WallDistance ? math.max(WallStiffness * (WallDistance - distance) - WallDamping * speedAway, 0.0) : 0.0;
        }

        private double3 DomainForce(double3 p, double3 v)
        {
            return Drag.Period.WhereWalls(new double3(
                Push(p.x + HalfSize.x, v.x) - Push(HalfSize.x - p.x, -v.x),
                Push(p.y + HalfSize.y, v.y) - Push(HalfSize.y - p.y, -v.y),
                Push(p.z + HalfSize.z, v.z) - Push(HalfSize.z - p.z, -v.z)));
        }

        // Faces whose prism holds the particle add up; edges and vertices count where no face does, the nearest alone.
        private double3 MeshForce(in CpuMesh mesh, double3 position, double3 velocity, double reach, ref double3 drag)
        {
            double range = mesh.Closed ? math.max(WallReach, reach) : reach;
            double3 move = velocity * TimeStep;
            double tie = 1e-4 * WallDistance;
            double3 force = double3.zero;
            bool faceContact = false;
            double nearest = 1e30;
            double3 nearestOffset = double3.zero;
            double3 nearestNormal = double3.zero;
            double hit = 1.0;
            double3 hitNormal = double3.zero;
            for (int t = mesh.FirstTriangle; t < mesh.EndTriangle; t++)
            {
                CpuTriangle triangle = Triangles[t];
                double3 unscaled = math.cross(triangle.B - triangle.A, triangle.C - triangle.A);
                double3 normal = unscaled / math.sqrt(math.max(math.dot(unscaled, unscaled), 1e-30));
                double height = math.dot(position - triangle.A, normal);
                if (math.abs(height) >= range) continue;

                double side = mesh.Closed || height >= 0.0 ? 1.0 : -1.0;
                double fraction = triangle.SegmentFraction(position, move);
                if (fraction < hit && math.dot(move, normal) * side < 0.0)
                {
                    hit = fraction;
                    hitNormal = normal * side;
                }

                double3 offset = position - triangle.ClosestPoint(position, out bool onFace);
                double distance = math.length(offset);
                if (distance < nearest - tie)
                {
                    nearest = distance;
                    nearestOffset = offset;
                    nearestNormal = normal;
                }
                else if (distance < nearest + tie)
                {
                    nearestNormal += normal; // neighbours that share the nearest edge or vertex
                }

                if (onFace && height * side >= 0.0 && height * side < WallDistance)
                {
                    force += WallForce(normal * side, height * side, velocity);
                    faceContact = true;
                }
            }

            bool behind = mesh.Closed && math.dot(nearestOffset, nearestNormal) < 0.0;
            if (behind && nearest < WallReach)
            {
                force = WallForce(nearestOffset / -nearest, -math.min(nearest, WallDistance), velocity);
            }
            else if (!faceContact && nearest < WallDistance)
            {
                force = WallForce(nearest > 0.0 ? nearestOffset / nearest : math.normalize(nearestNormal), nearest, velocity);
            }

            if (Drag.On && nearest < Drag.Distance)
            {
                double3 away = nearest > 0.0 ? nearestOffset / nearest : math.normalize(nearestNormal);
                drag += Drag.Mesh(away, behind ? 0.0 : nearest, velocity + drag * KickStep);
            }

            // A step that would cross a face is cut at the face.
            double missing = -math.dot(velocity, hitNormal) * (1.0 - hit) / KickStep - math.dot(force, hitNormal);
            return hit < 1.0 && missing > 0.0 ? force + hitNormal * missing : force;
        }
    }
}

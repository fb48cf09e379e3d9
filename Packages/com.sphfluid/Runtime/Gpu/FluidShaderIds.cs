using UnityEngine;

namespace SphFluid
{
    /// <summary>Property ids of the solver's kernels, one a global of Shaders/Solver and Shaders/Solver.</summary>
    internal static class FluidShaderIds
    {
        public static readonly int Particles = Shader.PropertyToID("_Particles");
        public static readonly int SortedParticles = Shader.PropertyToID("_SortedParticles");
        public static readonly int Grid = Shader.PropertyToID("_Grid");
        public static readonly int GridIndices = Shader.PropertyToID("_GridIndices");
        public static readonly int Density = Shader.PropertyToID("_Density");
        public static readonly int Pressure = Shader.PropertyToID("_Pressure");
        public static readonly int Force = Shader.PropertyToID("_Force");
        public static readonly int Acceleration = Shader.PropertyToID("_Acceleration");
        public static readonly int Counters = Shader.PropertyToID("_Counters");
        public static readonly int Triangles = Shader.PropertyToID("_Triangles");
        public static readonly int Colliders = Shader.PropertyToID("_Colliders");

        public static readonly int ParticleCount = Shader.PropertyToID("_ParticleCount");
        public static readonly int PaddedCount = Shader.PropertyToID("_PaddedCount");
        public static readonly int CellCount = Shader.PropertyToID("_CellCount");
        public static readonly int ColliderCount = Shader.PropertyToID("_ColliderCount");

        public static readonly int GridOrigin = Shader.PropertyToID("_GridOrigin");
        public static readonly int CellSize = Shader.PropertyToID("_CellSize");
        public static readonly int GridCounts = Shader.PropertyToID("_GridCounts");

        public static readonly int Input = Shader.PropertyToID("_Input");
        public static readonly int Data = Shader.PropertyToID("_Data");
        public static readonly int Level = Shader.PropertyToID("_Level");
        public static readonly int LevelMask = Shader.PropertyToID("_LevelMask");
        public static readonly int Width = Shader.PropertyToID("_Width");
        public static readonly int Height = Shader.PropertyToID("_Height");
        public static readonly int MergeDistance = Shader.PropertyToID("_MergeDistance");

        public static readonly int SmoothLength = Shader.PropertyToID("_SmoothLength");
        public static readonly int SmoothLengthSquared = Shader.PropertyToID("_SmoothLengthSquared");
        public static readonly int DensityCoefficient = Shader.PropertyToID("_DensityCoefficient");
        public static readonly int PressureCoefficient = Shader.PropertyToID("_PressureCoefficient");
        public static readonly int ViscosityCoefficient = Shader.PropertyToID("_ViscosityCoefficient");
        public static readonly int SelfDensity = Shader.PropertyToID("_SelfDensity");
        public static readonly int RestDensity = Shader.PropertyToID("_RestDensity");
        public static readonly int Stiffness = Shader.PropertyToID("_Stiffness");
        public static readonly int PressureFloor = Shader.PropertyToID("_PressureFloor");

        public static readonly int TimeStep = Shader.PropertyToID("_TimeStep");
        public static readonly int FirstStep = Shader.PropertyToID("_FirstStep");
        public static readonly int Gravity = Shader.PropertyToID("_Gravity");
        public static readonly int PrintedMass = Shader.PropertyToID("_PrintedMass");
        public static readonly int AccelerationLimit = Shader.PropertyToID("_AccelerationLimit");
        public static readonly int DomainHalfSize = Shader.PropertyToID("_DomainHalfSize");
        public static readonly int WallStiffness = Shader.PropertyToID("_WallStiffness");
        public static readonly int WallDamping = Shader.PropertyToID("_WallDamping");
        public static readonly int WallDistance = Shader.PropertyToID("_WallDistance");
        public static readonly int WallReach = Shader.PropertyToID("_WallReach");

        public static readonly int KickStep = Shader.PropertyToID("_KickStep");
        public static readonly int KickPart = Shader.PropertyToID("_KickPart");
        public static readonly int PeriodLength = Shader.PropertyToID("_PeriodLength");
        public static readonly int PeriodRate = Shader.PropertyToID("_PeriodRate");
        public static readonly int BodyForceCentre = Shader.PropertyToID("_BodyForceCentre");
        public static readonly int BodyForceRate = Shader.PropertyToID("_BodyForceRate");
        public static readonly int DragSpeed = Shader.PropertyToID("_DragSpeed");
        public static readonly int DragDistance = Shader.PropertyToID("_DragDistance");
        public static readonly int DragStep = Shader.PropertyToID("_DragStep");
        public static readonly int WallLowX = Shader.PropertyToID("_WallLowX");
        public static readonly int WallLowY = Shader.PropertyToID("_WallLowY");
        public static readonly int WallLowZ = Shader.PropertyToID("_WallLowZ");
        public static readonly int WallHighX = Shader.PropertyToID("_WallHighX");
        public static readonly int WallHighY = Shader.PropertyToID("_WallHighY");
        public static readonly int WallHighZ = Shader.PropertyToID("_WallHighZ");
    }
}

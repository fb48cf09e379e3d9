using UnityEngine;

namespace SphFluid
{
    /// <summary>Property ids of the kernels of Shaders/Solver/Standard.</summary>
    internal static class StandardShaderIds
    {
        public static readonly int Positions = Shader.PropertyToID("_Positions");
        public static readonly int Velocities = Shader.PropertyToID("_Velocities");
        public static readonly int PositionsOut = Shader.PropertyToID("_PositionsOut");
        public static readonly int VelocitiesOut = Shader.PropertyToID("_VelocitiesOut");
        public static readonly int NewPositions = Shader.PropertyToID("_NewPositions");
        public static readonly int NewVelocities = Shader.PropertyToID("_NewVelocities");
        public static readonly int NewPositionsOut = Shader.PropertyToID("_NewPositionsOut");
        public static readonly int NewVelocitiesOut = Shader.PropertyToID("_NewVelocitiesOut");
        public static readonly int DensityIn = Shader.PropertyToID("_DensityIn");
        public static readonly int DensityOut = Shader.PropertyToID("_DensityOut");
        public static readonly int CellCount = Shader.PropertyToID("_CellCount");
        public static readonly int CellTotal = Shader.PropertyToID("_CellTotal");
        public static readonly int CellStartOut = Shader.PropertyToID("_CellStartOut");
        public static readonly int BlockSum = Shader.PropertyToID("_BlockSum");
        public static readonly int Rank = Shader.PropertyToID("_Rank");
        public static readonly int RankOut = Shader.PropertyToID("_RankOut");
        public static readonly int Order = Shader.PropertyToID("_Order");
        public static readonly int OrderOut = Shader.PropertyToID("_OrderOut");
        public static readonly int ParticlesOut = Shader.PropertyToID("_ParticlesOut");
        public static readonly int GridIndicesOut = Shader.PropertyToID("_GridIndicesOut");

        public static readonly int WallSlot = Shader.PropertyToID("_WallSlot");
        public static readonly int WallSlotOut = Shader.PropertyToID("_WallSlotOut");
        public static readonly int NearWalls = Shader.PropertyToID("_NearWalls");
        public static readonly int NearWallsOut = Shader.PropertyToID("_NearWallsOut");
        public static readonly int FaceDistance = Shader.PropertyToID("_FaceDistance");

        public static readonly int ContactList = Shader.PropertyToID("_ContactList");
        public static readonly int ContactListIn = Shader.PropertyToID("_ContactListIn");
        public static readonly int ContactArguments = Shader.PropertyToID("_ContactArguments");
        public static readonly int ContactArgumentsIn = Shader.PropertyToID("_ContactArgumentsIn");
        public static readonly int ContactDistance = Shader.PropertyToID("_ContactDistance");
        public static readonly int SweepDistance = Shader.PropertyToID("_SweepDistance");
        public static readonly int ContactFloor = Shader.PropertyToID("_ContactFloor");
        public static readonly int ContactTolerance = Shader.PropertyToID("_ContactTolerance");
        public static readonly int LongestDisplacement = Shader.PropertyToID("_LongestDisplacement");

        public static readonly int InverseSupport = Shader.PropertyToID("_InverseSupport");
        public static readonly int DensityFactor = Shader.PropertyToID("_DensityFactor");
        public static readonly int InverseMoment = Shader.PropertyToID("_InverseMoment");
        public static readonly int SoundSpeedSquared = Shader.PropertyToID("_SoundSpeedSquared");
        public static readonly int SuctionFloor = Shader.PropertyToID("_SuctionFloor");
        public static readonly int SlopeFactor = Shader.PropertyToID("_SlopeFactor");
        public static readonly int WallPush = Shader.PropertyToID("_WallPush");
        public static readonly int ViscosityFactor = Shader.PropertyToID("_ViscosityFactor");

        public static readonly int SupportRatio = Shader.PropertyToID("_SupportRatio");
        public static readonly int MirrorSpacing = Shader.PropertyToID("_MirrorSpacing");
        public static readonly int DomainHalf = Shader.PropertyToID("_DomainHalf");
        public static readonly int ShellDistance = Shader.PropertyToID("_ShellDistance");
        public static readonly int KickStep = Shader.PropertyToID("_KickStep");
        public static readonly int FirstStep = Shader.PropertyToID("_FirstStep");
        public static readonly int Damping = Shader.PropertyToID("_Damping");
        public static readonly int WallViscosity = Shader.PropertyToID("_WallViscosity");
        public static readonly int NoSlipViscosity = Shader.PropertyToID("_NoSlipViscosity");
        public static readonly int WallVelocities = Shader.PropertyToID("_WallVelocities");
        public static readonly int BodyForceCentre = Shader.PropertyToID("_BodyForceCentre");
        public static readonly int BodyForceRate = Shader.PropertyToID("_BodyForceRate");
    }
}

using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The package's shaders by path, without the assets that users edit.</summary>
    public static class TestShaders
    {
        const string Package = "Packages/com.sphfluid/";

        /// <summary>A shader set with the blocks of both methods; destroy it after use.</summary>
        public static FluidShaderSet CreateSet()
        {
            GpuTest.Require();
            var set = ScriptableObject.CreateInstance<FluidShaderSet>();
            set.CalculateParticleCellValue = Thesis("CalculateParticleCellValue");
            set.BitonicSort = Thesis("BitonicSort");
            set.ResetGridIndices = Thesis("ResetGridIndices");
            set.SetGridIndices = Thesis("SetGridIndices");
            set.SortParticles = Thesis("SortParticles");
            set.CalculateDensity = Thesis("CalculateDensity");
            set.CalculateForce = Thesis("CalculateForce");
            set.CalculateAcceleration = Thesis("CalculateAcceleration");
            set.CalculateNewPosition = Thesis("CalculateNewPosition");
            set.MeasureVitals = Load("Shaders/Diagnostics/MeasureVitals.compute");
            set.CountCells = Load("Shaders/Methods/Standard/CountCells.compute");
            set.ScanCells = Load("Shaders/Methods/Standard/ScanCells.compute");
            set.ScatterParticles = Load("Shaders/Methods/Standard/ScatterParticles.compute");
            set.StandardDensity = Load("Shaders/Methods/Standard/StandardDensity.compute");
            set.MoveParticles = Load("Shaders/Methods/Standard/MoveParticles.compute");
            set.GatherWalls = Load("Shaders/Methods/Standard/GatherWalls.compute");
            set.FindContacts = Load("Shaders/Methods/Standard/FindContacts.compute");
            set.ResolveContacts = Load("Shaders/Methods/Standard/ResolveContacts.compute");
            set.DampVelocities = Load("Shaders/Methods/Standard/DampVelocities.compute");
            set.PublishParticles = Load("Shaders/Methods/Standard/PublishParticles.compute");
            return set;
        }

        /// <summary>A compute shader of the package.</summary>
        public static ComputeShader Load(string path)
        {
            GpuTest.Require();
            return TestAssets.Load<ComputeShader>(Package + path);
        }

        static ComputeShader Thesis(string block)
        {
            return Load($"Shaders/Methods/Thesis/{block}.compute");
        }
    }
}

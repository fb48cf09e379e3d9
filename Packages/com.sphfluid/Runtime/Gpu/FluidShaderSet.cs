using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Every compute shader and shader of the package in one asset. A profile references it, so that components made
    /// from code, play mode and player builds find the shaders without a Resources folder.
    /// </summary>
    [CreateAssetMenu(menuName = "SPH Fluid/Fluid Shader Set", fileName = "FluidShaderSet", order = 201)]
    public sealed class FluidShaderSet : ScriptableObject
    {
        [Header("Thesis method")]
        [SerializeField, Tooltip("Kernel CalculateParticleCellValue: the grid cell of each particle.")]
        ComputeShader calculateParticleCellValue;

        [SerializeField, Tooltip("Kernels BitonicSort and MatrixTranspose: sorts the pairs of cell and particle.")]
        ComputeShader bitonicSort;

        [SerializeField, Tooltip("Kernel ResetGridIndices: empties the range of each cell.")]
        ComputeShader resetGridIndices;

        [SerializeField, Tooltip("Kernel SetGridIndices: the range of particles in each cell.")]
        ComputeShader setGridIndices;

        [SerializeField, Tooltip("Kernel SortParticles: puts the particles in the order of their cells.")]
        ComputeShader sortParticles;

        [SerializeField, Tooltip("Kernel CalculateDensity: density and pressure.")]
        ComputeShader calculateDensity;

        [SerializeField, Tooltip("Kernel CalculateForce: pressure and viscosity.")]
        ComputeShader calculateForce;

        [SerializeField, Tooltip("Kernel CalculateAcceleration: limit, collisions, gravity.")]
        ComputeShader calculateAcceleration;

        [SerializeField, Tooltip("Kernel CalculateNewPosition: leapfrog.")]
        ComputeShader calculateNewPosition;

        [Header("Standard method")]
        [SerializeField, Tooltip("Kernels ClearCells and LoadParticles: takes particles that came from outside.")]
        ComputeShader loadParticles;

        [SerializeField, Tooltip("Kernels ScanReduce and ScanApply: the first particle of each cell.")]
        ComputeShader scanCells;

        [SerializeField, Tooltip("Kernels Scatter, ScatterOrder and Reorder: particles in the order of their cells.")]
        ComputeShader scatterParticles;

        [SerializeField, Tooltip("Kernel StandardDensity: density and pressure.")]
        ComputeShader standardDensity;

        [SerializeField, Tooltip("Kernel MoveParticles: forces, motion, walls, cell counts.")]
        ComputeShader moveParticles;

        [SerializeField, Tooltip("Kernel GatherWalls: colliders near each particle.")]
        ComputeShader gatherWalls;

        [SerializeField, Tooltip("Kernel FindContacts: steps that meet a collider.")]
        ComputeShader findContacts;

        [SerializeField, Tooltip("Kernel ResolveContacts: where those steps go.")]
        ComputeShader resolveContacts;

        [SerializeField, Tooltip("Kernel DampVelocities: brings the liquid to rest before the start.")]
        ComputeShader dampVelocities;

        [SerializeField, Tooltip("Kernels PublishParticles and PublishCells: the liquid as drawing reads it.")]
        ComputeShader publishParticles;

        [Header("Surface")]
        [SerializeField, Tooltip("Kernels ResetMCGrid and SetMCGridDensityFactors: the density grid of the surface.")]
        ComputeShader surfaceField;

        [SerializeField, Tooltip("Kernels of the compute twin of the geometry-shader marching cubes, for mesh export and tests.")]
        ComputeShader surfaceMesh;

        [SerializeField, Tooltip("Kernel ClearSurfaceBlocks: no block of the sparse surface is active.")]
        ComputeShader clearSurfaceBlocks;

        [SerializeField, Tooltip("Kernels PrepareSurfaceParticles and PrepareThesisParticles: what the field takes of each particle, and which blocks lie near the surface.")]
        ComputeShader prepareSurfaceParticles;

        [SerializeField, Tooltip("Kernels ListSurfaceBlocks and BeginSurfaceRound: slots for the blocks near the surface.")]
        ComputeShader listSurfaceBlocks;

        [SerializeField, Tooltip("Kernel SampleBlocks: the field at the samples of those blocks.")]
        ComputeShader sampleBlocks;

        [SerializeField, Tooltip("Kernel CountBlocks: how many vertices and triangles each block of the sparse surface has.")]
        ComputeShader countBlocks;

        [SerializeField, Tooltip("Kernel SurfaceDrawArguments: what of the sparse surface is emitted and drawn.")]
        ComputeShader surfaceDrawArguments;

        [SerializeField, Tooltip("Kernel EmitBlocks: the vertices and triangles of the sparse surface.")]
        ComputeShader emitBlocks;

        [SerializeField, Tooltip("Kernel WriteSurfaceMesh: the sparse surface as a Unity mesh.")]
        ComputeShader writeSurfaceMesh;

        [Header("Diagnostics")]
        [SerializeField, Tooltip("Kernel MeasureStatistics: energies, momentum, compression, clumps and more of a whole liquid.")]
        ComputeShader measureStatistics;

        [Header("Drawing")]
        [SerializeField, Tooltip("Particles as textured, lit squares that face the camera.")]
        Shader particleShader;

        [SerializeField, Tooltip("Marching cubes in a geometry shader, the thesis's way. Needs a device with geometry shaders.")]
        Shader surfaceGeometryShader;

        [SerializeField, Tooltip("The sparse surface, opaque.")]
        Shader surfaceShader;

        [SerializeField, Tooltip("The sparse surface as clear water.")]
        Shader waterShader;

        [SerializeField, Tooltip("How much water lies behind each pixel, for the shader above.")]
        Shader waterThicknessShader;

        [SerializeField, Tooltip("The nearest water's depth, where a render pipeline lets water only be blended over the scene.")]
        Shader waterDepthShader;

        /// <summary>Kernel CalculateParticleCellValue: the grid cell of each particle.</summary>
        public ComputeShader CalculateParticleCellValue { get => calculateParticleCellValue; set => calculateParticleCellValue = value; }

        /// <summary>Kernels BitonicSort and MatrixTranspose: sorts the pairs of cell and particle.</summary>
        public ComputeShader BitonicSort { get => bitonicSort; set => bitonicSort = value; }

        /// <summary>Kernel ResetGridIndices: empties the range of each cell.</summary>
        public ComputeShader ResetGridIndices { get => resetGridIndices; set => resetGridIndices = value; }

        /// <summary>Kernel SetGridIndices: the range of particles in each cell.</summary>
        public ComputeShader SetGridIndices { get => setGridIndices; set => setGridIndices = value; }

        /// <summary>Kernel SortParticles: puts the particles in the order of their cells.</summary>
        public ComputeShader SortParticles { get => sortParticles; set => sortParticles = value; }

        /// <summary>Kernel CalculateDensity: density and pressure.</summary>
        public ComputeShader CalculateDensity { get => calculateDensity; set => calculateDensity = value; }

        /// <summary>Kernel CalculateForce: pressure and viscosity.</summary>
        public ComputeShader CalculateForce { get => calculateForce; set => calculateForce = value; }

        /// <summary>Kernel CalculateAcceleration: limit, collisions, gravity.</summary>
        public ComputeShader CalculateAcceleration { get => calculateAcceleration; set => calculateAcceleration = value; }

        /// <summary>Kernel CalculateNewPosition: leapfrog.</summary>
        public ComputeShader CalculateNewPosition { get => calculateNewPosition; set => calculateNewPosition = value; }

        /// <summary>Kernels ClearCells and LoadParticles: takes particles that came from outside.</summary>
        public ComputeShader LoadParticles { get => loadParticles; set => loadParticles = value; }

        /// <summary>Kernels ScanReduce and ScanApply: the first particle of each cell.</summary>
        public ComputeShader ScanCells { get => scanCells; set => scanCells = value; }

        /// <summary>Kernels Scatter, ScatterOrder and Reorder: particles in the order of their cells.</summary>
        public ComputeShader ScatterParticles { get => scatterParticles; set => scatterParticles = value; }

        /// <summary>Kernel StandardDensity: density and pressure.</summary>
        public ComputeShader StandardDensity { get => standardDensity; set => standardDensity = value; }

        /// <summary>Kernel MoveParticles: forces, motion, walls, cell counts.</summary>
        public ComputeShader MoveParticles { get => moveParticles; set => moveParticles = value; }

        /// <summary>Kernel GatherWalls: colliders near each particle.</summary>
        public ComputeShader GatherWalls { get => gatherWalls; set => gatherWalls = value; }

        /// <summary>Kernel FindContacts: steps that meet a collider.</summary>
        public ComputeShader FindContacts { get => findContacts; set => findContacts = value; }

        /// <summary>Kernel ResolveContacts: where those steps go.</summary>
        public ComputeShader ResolveContacts { get => resolveContacts; set => resolveContacts = value; }

        /// <summary>Kernel DampVelocities: brings the liquid to rest before the start.</summary>
        public ComputeShader DampVelocities { get => dampVelocities; set => dampVelocities = value; }

        /// <summary>Kernels PublishParticles and PublishCells: the liquid as drawing reads it.</summary>
        public ComputeShader PublishParticles { get => publishParticles; set => publishParticles = value; }

        /// <summary>Kernels ResetMCGrid and SetMCGridDensityFactors: the density grid of the surface.</summary>
        public ComputeShader SurfaceField { get => surfaceField; set => surfaceField = value; }

        /// <summary>Kernels of the compute twin of the geometry-shader marching cubes, for mesh export and tests.</summary>
        public ComputeShader SurfaceMesh { get => surfaceMesh; set => surfaceMesh = value; }

        /// <summary>Kernel ClearSurfaceBlocks: no block of the sparse surface is active.</summary>
        public ComputeShader ClearSurfaceBlocks { get => clearSurfaceBlocks; set => clearSurfaceBlocks = value; }

        /// <summary>Kernels PrepareSurfaceParticles and PrepareThesisParticles: what the field takes of each particle, and which blocks lie near the surface.</summary>
        public ComputeShader PrepareSurfaceParticles { get => prepareSurfaceParticles; set => prepareSurfaceParticles = value; }

        /// <summary>Kernels ListSurfaceBlocks and BeginSurfaceRound: slots for the blocks near the surface.</summary>
        public ComputeShader ListSurfaceBlocks { get => listSurfaceBlocks; set => listSurfaceBlocks = value; }

        /// <summary>Kernel SampleBlocks: the field at the samples of those blocks.</summary>
        public ComputeShader SampleBlocks { get => sampleBlocks; set => sampleBlocks = value; }

        /// <summary>Kernel CountBlocks: how many vertices and triangles each block of the sparse surface has.</summary>
        public ComputeShader CountBlocks { get => countBlocks; set => countBlocks = value; }

        /// <summary>Kernel SurfaceDrawArguments: what of the sparse surface is emitted and drawn.</summary>
        public ComputeShader SurfaceDrawArguments { get => surfaceDrawArguments; set => surfaceDrawArguments = value; }

        /// <summary>Kernel EmitBlocks: the vertices and triangles of the sparse surface.</summary>
        public ComputeShader EmitBlocks { get => emitBlocks; set => emitBlocks = value; }

        /// <summary>Kernel WriteSurfaceMesh: the sparse surface as a Unity mesh.</summary>
        public ComputeShader WriteSurfaceMesh { get => writeSurfaceMesh; set => writeSurfaceMesh = value; }

        /// <summary>Kernel MeasureStatistics: energies, momentum, compression, clumps and more of a whole liquid.</summary>
        public ComputeShader MeasureStatistics { get => measureStatistics; set => measureStatistics = value; }

        /// <summary>Particles as textured, lit squares that face the camera.</summary>
        public Shader ParticleShader { get => particleShader; set => particleShader = value; }

        /// <summary>Marching cubes in a geometry shader, the thesis's way. Needs a device with geometry shaders.</summary>
        public Shader SurfaceGeometryShader { get => surfaceGeometryShader; set => surfaceGeometryShader = value; }

        /// <summary>The sparse surface, opaque.</summary>
        public Shader SurfaceShader { get => surfaceShader; set => surfaceShader = value; }

        /// <summary>The sparse surface as clear water.</summary>
        public Shader WaterShader { get => waterShader; set => waterShader = value; }

        /// <summary>How much water lies behind each pixel, for <see cref="WaterShader"/>.</summary>
        public Shader WaterThicknessShader { get => waterThicknessShader; set => waterThicknessShader = value; }

        /// <summary>The nearest water's depth, where a render pipeline lets water only be blended over the scene.</summary>
        public Shader WaterDepthShader { get => waterDepthShader; set => waterDepthShader = value; }

        /// <summary>Names of the empty entries that a simulation needs.</summary>
        /// <param name="method">Its method.</param>
        /// <returns>Field names in the inspector's order; empty when all are there.</returns>
        public IReadOnlyList<string> MissingFor(FluidMethodKind method)
        {
            var missing = new List<string>();
            if (method == FluidMethodKind.Standard) CheckStandard(missing);
            else CheckThesis(missing);
            return missing;
        }

        /// <summary>Names of all empty entries, those of drawing and diagnostics included.</summary>
        /// <returns>Field names in the inspector's order; empty when all are there.</returns>
        public IReadOnlyList<string> Validate()
        {
            var missing = new List<string>();
            CheckThesis(missing);
            CheckStandard(missing);
            Check(surfaceField, nameof(surfaceField), missing);
            Check(surfaceMesh, nameof(surfaceMesh), missing);
            Check(clearSurfaceBlocks, nameof(clearSurfaceBlocks), missing);
            Check(prepareSurfaceParticles, nameof(prepareSurfaceParticles), missing);
            Check(listSurfaceBlocks, nameof(listSurfaceBlocks), missing);
            Check(sampleBlocks, nameof(sampleBlocks), missing);
            Check(countBlocks, nameof(countBlocks), missing);
            Check(surfaceDrawArguments, nameof(surfaceDrawArguments), missing);
            Check(emitBlocks, nameof(emitBlocks), missing);
            Check(writeSurfaceMesh, nameof(writeSurfaceMesh), missing);
            Check(measureStatistics, nameof(measureStatistics), missing);
            Check(particleShader, nameof(particleShader), missing);
            Check(surfaceGeometryShader, nameof(surfaceGeometryShader), missing);
            Check(surfaceShader, nameof(surfaceShader), missing);
            Check(waterShader, nameof(waterShader), missing);
            Check(waterThicknessShader, nameof(waterThicknessShader), missing);
            Check(waterDepthShader, nameof(waterDepthShader), missing);
            return missing;
        }

        void CheckThesis(List<string> missing)
        {
            Check(calculateParticleCellValue, nameof(calculateParticleCellValue), missing);
            Check(bitonicSort, nameof(bitonicSort), missing);
            Check(resetGridIndices, nameof(resetGridIndices), missing);
            Check(setGridIndices, nameof(setGridIndices), missing);
            Check(sortParticles, nameof(sortParticles), missing);
            Check(calculateDensity, nameof(calculateDensity), missing);
            Check(calculateForce, nameof(calculateForce), missing);
            Check(calculateAcceleration, nameof(calculateAcceleration), missing);
            Check(calculateNewPosition, nameof(calculateNewPosition), missing);
        }

        void CheckStandard(List<string> missing)
        {
            Check(loadParticles, nameof(loadParticles), missing);
            Check(scanCells, nameof(scanCells), missing);
            Check(scatterParticles, nameof(scatterParticles), missing);
            Check(standardDensity, nameof(standardDensity), missing);
            Check(moveParticles, nameof(moveParticles), missing);
            Check(gatherWalls, nameof(gatherWalls), missing);
            Check(findContacts, nameof(findContacts), missing);
            Check(resolveContacts, nameof(resolveContacts), missing);
            Check(dampVelocities, nameof(dampVelocities), missing);
            Check(publishParticles, nameof(publishParticles), missing);
        }

        static void Check(Object reference, string name, List<string> missing)
        {
            if (reference == null) missing.Add(name);
        }
    }
}

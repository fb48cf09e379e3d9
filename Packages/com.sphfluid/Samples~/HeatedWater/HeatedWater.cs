using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Samples
{
    /// <summary>
    /// A temperature for each particle of a liquid, kept and computed here: a hot stone warms what touches it, and warmth goes on to
    /// neighbours. The liquid's particles are only read. Each has the number that it started with as Id, by which its temperature is found,
    /// so this is for liquids without emitters.
    /// </summary>
    public sealed class HeatedWater : MonoBehaviour
    {
        private const int GroupSize = 64;

        [SerializeField, Tooltip("The liquid.")]
        private FluidSimulation simulation;

        [SerializeField, Tooltip("What is hot: a sphere whose diameter is its scale along x.")]
        private Transform stone;

        [SerializeField, Tooltip("HeatParticles.compute")]
        private ComputeShader kernels;

        [SerializeField, Tooltip("HeatedParticles.shader")]
        private Shader shader;

        [SerializeField, Min(0f), Tooltip("How fast the stone warms what lies next to it [1/s].")]
        private float heating = 12f;

        [SerializeField, Min(0f), Tooltip("How fast neighbours even out their temperatures [1/s].")]
        private float conduction = 3f;

        private CommandBuffer commands;
        private MaterialPropertyBlock properties;
        private Material material;
        private GraphicsBuffer temperatures, next;
        private int kernel;
        private double heatedUntil;

        private void OnEnable()
        {
            commands = new CommandBuffer { name = "Heated Water" };
            properties = new MaterialPropertyBlock();
            material = new Material(shader);
            kernel = kernels.FindKernel("HeatParticles");
            simulation.Started += Forget;
            simulation.Updated += HeatAndDraw;
        }

        private void OnDisable()
        {
            simulation.Started -= Forget;
            simulation.Updated -= HeatAndDraw;
            Forget(simulation);
            commands.Dispose();
            Destroy(material);
        }

        private void Forget(FluidSimulation started)
        {
            temperatures?.Dispose();
            next?.Dispose();
            temperatures = next = null;
        }

        private void HeatAndDraw(FluidSimulation updated)
        {
            if (!updated.TryGetBuffers(out FluidBuffers fluid)) return;
            if (temperatures == null) StartCold(fluid.ParticleCount);
            float seconds = (float)(updated.SimulatedTime - heatedUntil);
            heatedUntil = updated.SimulatedTime;
            if (seconds > 0f) Heat(fluid, seconds);
            Draw(fluid);
        }

        private void StartCold(int particles)
        {
            temperatures = new GraphicsBuffer(GraphicsBuffer.Target.Structured, particles, sizeof(float));
            next = new GraphicsBuffer(GraphicsBuffer.Target.Structured, particles, sizeof(float));
            temperatures.SetData(new float[particles]);
            heatedUntil = simulation.SimulatedTime;
        }

        private void Heat(in FluidBuffers fluid, float seconds)
        {
            commands.Clear();
            fluid.Bind(commands, kernels, kernel);
            commands.SetComputeBufferParam(kernels, kernel, "_Temperatures", temperatures);
            commands.SetComputeBufferParam(kernels, kernel, "_TemperaturesOut", next);
            commands.SetComputeIntParam(kernels, "_TemperatureCount", temperatures.count);
            commands.SetComputeVectorParam(kernels, "_Stone", stone.position);
            commands.SetComputeFloatParam(kernels, "_StoneRadius", 0.5f * stone.lossyScale.x);
            commands.SetComputeFloatParam(kernels, "_Heating", 1f - Mathf.Exp(-heating * seconds));
            commands.SetComputeFloatParam(kernels, "_Conduction", 1f - Mathf.Exp(-conduction * seconds));
            commands.DispatchCompute(kernels, kernel, (fluid.ParticleCount + GroupSize - 1) / GroupSize, 1, 1);
            Graphics.ExecuteCommandBuffer(commands);
            (temperatures, next) = (next, temperatures);
        }

        private void Draw(in FluidBuffers fluid)
        {
            fluid.Bind(properties);
            properties.SetBuffer("_Temperatures", temperatures);
            properties.SetInteger("_TemperatureCount", temperatures.count);
            var parameters = new RenderParams(material)
            {
                matProps = properties,
                worldBounds = new Bounds(simulation.transform.position, 2f * simulation.DomainSize.magnitude * Vector3.one),
            };
            Graphics.RenderPrimitives(parameters, MeshTopology.Triangles, 6 * fluid.ParticleCount);
        }
    }
}

using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The liquid's fastest speed, always that of the same number of stepped frames ago: however fast the read-backs arrive, the same
    /// liquid takes the same steps. By then the GPU has done that frame; where it has not, this waits for it.
    /// </summary>
    internal sealed class SpeedReadback
    {
        /// <summary>Age of the speed in frames with steps.</summary>
        public const int Delay = 3;

        readonly FluidSolver solver;
        readonly Slot[] slots = new Slot[Delay];
        int next;

        /// <summary>Starts with the speed that the constants are made for, or the present one where that is faster.</summary>
        public SpeedReadback(FluidSolver solver)
        {
            this.solver = solver;
            float speed = Mathf.Max(solver.Settings.MaxSpeed, Finite(solver.ReadCountersNow().MaxSpeed));
            for (int i = 0; i < Delay; i++) slots[i] = new Slot { Speed = speed, Known = true };
        }

        /// <summary>Speed of <see cref="Delay"/> frames ago [m/s].</summary>
        public float Speed
        {
            get
            {
                Slot oldest = slots[next];
                if (!oldest.Known) oldest.Wait();
                return oldest.Speed;
            }
        }

        /// <summary>Asks for the speed of a frame whose steps have been given to the GPU.</summary>
        public void Request()
        {
            var slot = new Slot { Speed = Speed };
            slots[next] = slot;
            next = (next + 1) % Delay;
            if (SystemInfo.supportsAsyncGPUReadback)
                slot.Request = AsyncGPUReadback.Request(solver.State.Published.Counters, sizeof(float), CounterReadback.MaxSpeed * sizeof(float), slot.Take);
            else
                slot.Take(solver.ReadCountersNow().MaxSpeed);
        }

        // A liquid at a speed without a number has flown apart; the guards report it.
        static float Finite(float speed) => speed >= 0f && speed < float.PositiveInfinity ? speed : float.MaxValue;

        sealed class Slot
        {
            public AsyncGPUReadbackRequest Request;
            public float Speed;
            public bool Known;

            public void Take(AsyncGPUReadbackRequest request)
            {
                if (Known) return;
                Known = true;
                if (request.hasError) return;
                Speed = Finite(request.GetData<float>()[0]);
            }

            public void Take(float speed)
            {
                Speed = Finite(speed);
                Known = true;
            }

            public void Wait()
            {
                Request.WaitForCompletion();
                Take(Request);
            }
        }
    }
}

using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// Linear waves of a liquid in a rectangular tank, by modes: η(x, t) = Σ η_n(t) cos k_n x, k_n = nπ/L, x from one end wall. Each is a
    /// pendulum, η_n″ + ω_n² η_n = f_n, ω_n² = g k_n tanh k_n H, that the tank's motion drives (Lamb, Hydrodynamics, §§ 228 and 257).
    /// <para>The modes of a liquid of particles are sums over all of them, (2H/N) Σ cos k_n x_i: no search for the surface, and a lattice
    /// at rest has none. That counts mass; weight compresses the liquid to 1 + gH/c² at the floor, and a surface that rises by η takes
    /// η (1 + gH/c²) of it at rest density.</para>
    /// </summary>
    internal sealed class TankModes
    {
        private readonly double gravity, compression;

        /// <summary>A tank.</summary>
        /// <param name="length">L [m].</param>
        /// <param name="depth">H at rest [m].</param>
        /// <param name="gravity">g [m/s²].</param>
        /// <param name="soundSpeed">c [m/s]; infinite for an incompressible liquid.</param>
        public TankModes(double length, double depth, double gravity, double soundSpeed)
        {
            Length = length;
            Depth = depth;
            this.gravity = gravity;
            compression = 1.0 + gravity * depth / (soundSpeed * soundSpeed);
        }

        /// <summary>L [m].</summary>
        public double Length { get; }

        /// <summary>H [m].</summary>
        public double Depth { get; }

        /// <summary>k_n [1/m].</summary>
        public double WaveNumber(int n) => n * Math.PI / Length;

        /// <summary>ω_n [1/s].</summary>
        public double Frequency(int n) => FrequencyOf(WaveNumber(n));

        /// <summary>ω of a wave number [1/s].</summary>
        public double FrequencyOf(double waveNumber) => Math.Sqrt(gravity * waveNumber * Math.Tanh(waveNumber * Depth));

        /// <summary>Level of modes 1, 2, … at a place [m].</summary>
        public double Level(double[] modes, double x)
        {
            double level = 0.0;
            for (int n = 1; n <= modes.Length; n++) level += modes[n - 1] * Math.Cos(WaveNumber(n) * x);
            return level;
        }

        /// <summary>Modes 1, 2, … of a state [m].</summary>
        /// <param name="state">The particles.</param>
        /// <param name="wall">x of the end wall that x is counted from [m], simulation space.</param>
        /// <param name="modes">Takes them.</param>
        /// <param name="displaced">How far that wall has moved into the liquid [m]: where it was there is none now, and that is no mode of
        /// the surface.</param>
        public void Measure(FluidSnapshot state, double wall, double[] modes, double displaced = 0.0)
        {
            Array.Clear(modes, 0, modes.Length);
            for (int i = 0; i < state.Count; i++)
            {
                // cos nθ by its recursion: cos (n + 1)θ = 2 cos θ cos nθ − cos (n − 1)θ.
                double cosine = Math.Cos(WaveNumber(1) * (state.LocalPositions[i].x - wall));
                double before = 1.0, at = cosine;
                for (int n = 0; n < modes.Length; n++)
                {
                    modes[n] += at;
                    (before, at) = (at, 2.0 * cosine * at - before);
                }
            }
            for (int n = 0; n < modes.Length; n++)
            {
                modes[n] = (2.0 * Depth * modes[n] / state.Count + 2.0 * Depth * displaced / Length) / compression;
            }
        }

        /// <summary>
        /// Mode n of a tank that starts to be pushed along x by an acceleration a at time zero, in the tank's frame: the liquid is at rest
        /// under gravity before [m].
        /// </summary>
        /// <param name="n">1 or more.</param>
        /// <param name="slope">a/g, of the level that it swings about.</param>
        /// <param name="time">t [s].</param>
        public double Tilted(int n, double slope, double time) => n % 2 == 0 ? 0.0 :
            -4.0 * slope * Length / (n * n * Math.PI * Math.PI) * (1.0 - Math.Cos(Frequency(n) * time));

        /// <summary>
        /// Mode n of a tank whose end wall at x = 0, from floor to surface, goes to X = ½S (1 − cos ωt) from time zero on [m]:
        /// f_n = 2 tanh(k_n H)/(k_n L) X″.
        /// </summary>
        /// <param name="n">1 or more.</param>
        /// <param name="stroke">S [m].</param>
        /// <param name="frequency">ω [1/s], none of the tank's own.</param>
        /// <param name="time">t [s].</param>
        public double Driven(int n, double stroke, double frequency, double time)
        {
            double k = WaveNumber(n), own = Frequency(n);
            double force = 2.0 * Math.Tanh(k * Depth) / (k * Length) * 0.5 * stroke * frequency * frequency;
            return force / (own * own - frequency * frequency) * (Math.Cos(frequency * time) - Math.Cos(own * time));
        }
    }
}

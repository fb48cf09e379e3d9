using System;

namespace SphFluid
{
    /// <summary>
    /// The raw field of a pool of lattice layers at z = 0, −1, −2 …, endless across, its particles weighted, moved and stretched as
    /// Shaders/Surface/Sparse/PrepareSurfaceParticles.compute has it. Lengths in spacings.
    /// </summary>
    sealed class LatticePool
    {
        // SHAPE_RATIO in Shaders/Surface/Sparse/KernelShapes.hlsl.
        const double ShapeRatio = 4.0;

        readonly Layer[] layers;

        public LatticePool(double radius, double smoothing, int layerCount, bool anisotropic)
        {
            Radius = radius;
            layers = new Layer[layerCount];
            for (int i = 0; i < layerCount; i++)
                layers[i] = new Layer(radius, i, smoothing, anisotropic);
        }

        /// <summary>R of the kernel.</summary>
        public double Radius { get; }

        /// <summary>The field's value.</summary>
        public double At(double x, double y, double z)
        {
            double sum = 0.0;
            foreach (Layer layer in layers)
                sum += layer.At(x, y, z);
            return sum;
        }

        readonly struct Layer
        {
            readonly double weight, height, across, along; // across the surface, along it: radii of the kernel

            public Layer(double radius, int depth, double smoothing, bool anisotropic)
            {
                int reach = (int)Math.Ceiling(radius);
                double kernels = 0.0, sum = 0.0, moment = 0.0, squareX = 0.0, squareZ = 0.0;
                for (int z = -reach; z <= Math.Min(reach, depth); z++) // the layers above the last are missing
                {
                    for (int y = -reach; y <= reach; y++)
                    {
                        for (int x = -reach; x <= reach; x++)
                        {
                            double q2 = (x * x + y * y + z * z) / (radius * radius);
                            if (q2 >= 1.0) continue;
                            double w = 1.0 - q2 * Math.Sqrt(q2);
                            kernels += Math.Pow(1.0 - q2, 3.0);
                            sum += w;
                            moment += w * z;
                            squareX += w * x * x;
                            squareZ += w * z * z;
                        }
                    }
                }

                double mean = moment / sum;
                height = -depth + smoothing * Math.Max(-1.0, Math.Min(1.0, mean));
                weight = anisotropic ? WeightAtRest(radius) : 1.0 / kernels;
                across = along = radius;
                if (!anisotropic) return;
                double varianceX = squareX / sum, varianceZ = squareZ / sum - mean * mean;
                double least = Math.Max(varianceX, varianceZ) / ShapeRatio;
                varianceX = Math.Max(varianceX, least);
                varianceZ = Math.Max(varianceZ, least);
                double scale = radius * Math.Pow(varianceX * varianceX * varianceZ, -1.0 / 3.0);
                along = scale * varianceX;
                across = scale * varianceZ;
            }

            public double At(double x, double y, double z)
            {
                double dz = (z - height) / across, left = 1.0 - dz * dz, sum = 0.0;
                if (left <= 0.0) return 0.0;
                for (int j = (int)Math.Ceiling(y - along); j <= y + along; j++)
                {
                    for (int i = (int)Math.Ceiling(x - along); i <= x + along; i++)
                    {
                        double t = left - ((x - i) * (x - i) + (y - j) * (y - j)) / (along * along);
                        if (t > 0.0) sum += t * t * t;
                    }
                }

                return weight * sum;
            }

            // W(0) dx³ of poly6.
            static double WeightAtRest(double radius) => 315.0 / (64.0 * Math.PI * radius * radius * radius);
        }
    }
}

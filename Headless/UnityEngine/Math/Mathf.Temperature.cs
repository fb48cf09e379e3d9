namespace UnityEngine;

public partial struct Mathf
{
    /// <summary>Linear color of a black body, its brightest part 1, by M. Krystek's fit of 1985; 1,000 to 20,000 K.</summary>
    public static Color CorrelatedColorTemperatureToRGB(float kelvin)
    {
        double t = System.Math.Clamp(kelvin, 1000.0, 20000.0);
        double u = (0.860117757 + (1.54118254e-4 * t) + (1.28641212e-7 * t * t)) / (1.0 + (8.42420235e-4 * t) + (7.08145163e-7 * t * t));
        double v = (0.317398726 + (4.22806245e-5 * t) + (4.20481691e-8 * t * t)) / (1.0 - (2.89741816e-5 * t) + (1.61456053e-7 * t * t));

        // CIE 1960 u, v to X, Y, Z with Y = 1, then linear sRGB.
        double x = 1.5 * u / v;
        double z = (4.0 - u - (10.0 * v)) / (2.0 * v);
        double r = (3.2406 * x) - 1.5372 - (0.4986 * z);
        double g = (-0.9689 * x) + 1.8758 + (0.0415 * z);
        double b = (0.0557 * x) - 0.2040 + (1.0570 * z);
        double most = System.Math.Max(r, System.Math.Max(g, b));
        return new Color((float)System.Math.Max(r / most, 0.0), (float)System.Math.Max(g / most, 0.0), (float)System.Math.Max(b / most, 0.0));
    }
}

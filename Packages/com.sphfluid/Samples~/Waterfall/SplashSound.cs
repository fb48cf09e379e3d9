using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Sounds as loud as the water is fast at this object's sensor.</summary>
    [RequireComponent(typeof(FluidSensor))]
    public sealed class SplashSound : MonoBehaviour
    {
        private const int SampleRate = 22050;

        [SerializeField, Tooltip("Sound of rushing water, in a loop. Empty: noise that is made when the scene begins.")]
        private AudioClip clip;

        [SerializeField, Min(0.1f), Tooltip("Speed at full volume [m/s].")]
        private float loudSpeed = 4f;

        private FluidSensor sensor;
        private AudioSource source;
        private AudioClip noise;

        private void Awake()
        {
            sensor = GetComponent<FluidSensor>();
            if (clip == null) clip = noise = Rush();
            source = gameObject.AddComponent<AudioSource>();
            source.clip = clip;
            source.loop = true;
            source.spatialBlend = 1f;
            source.volume = 0f;
            source.Play();
        }

        private void Update()
        {
            float heard = sensor.HasValue ? Mathf.Clamp01(sensor.Value / loudSpeed) : 0f;
            source.volume = Mathf.MoveTowards(source.volume, heard, 2f * Time.deltaTime);
        }

        private void OnDestroy() => Destroy(noise);

        // White noise through a low-pass filter: two seconds, faded at both ends so that the loop has no click.
        private static AudioClip Rush()
        {
            var random = new System.Random(1);
            var samples = new float[2 * SampleRate];
            float last = 0f;
            for (int i = 0; i < samples.Length; i++)
            {
                last += 0.25f * ((float)(2.0 * random.NextDouble() - 1.0) - last);
                samples[i] = last * Mathf.Clamp01(Mathf.Min(i, samples.Length - i) / 1000f);
            }
            AudioClip made = AudioClip.Create("Rush", samples.Length, 1, SampleRate, false);
            made.SetData(samples, 0);
            return made;
        }
    }
}

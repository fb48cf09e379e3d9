using UnityEngine;

namespace Ripples
{
    [CreateAssetMenu(menuName = "Ripples/Pool Settings")]
    public sealed class PoolSettings : ScriptableObject
    {
        [Range(0f, 0.5f)] public float courant = 0.3f;
        public float damping = 0.998f;
        public Vector2[] drops = { new Vector2(0.5f, 0.5f) };
    }
}

using UnityEngine;

namespace Ripples
{
    public sealed class Turntable : MonoBehaviour
    {
        public Vector3 axis = Vector3.forward;
        public float degreesPerSecond = 90f;
        public Transform follow;

        void Update()
        {
            transform.Rotate(axis, degreesPerSecond * Time.deltaTime);
            if (follow != null) transform.position = follow.position + Vector3.right * 1.3f;
        }
    }
}

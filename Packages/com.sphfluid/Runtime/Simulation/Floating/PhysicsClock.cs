using System;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace SphFluid
{
    /// <summary>How long a scene's physics was stepped, where only a script knows: a hidden body that goes 1 m a second.</summary>
    internal sealed class PhysicsClock : IDisposable
    {
        private Rigidbody hand;

        /// <summary>Time that was stepped since the last call [s].</summary>
        public float Advance(Scene scene)
        {
            if (hand == null) Begin(scene);
            float time = hand.position.x;
            hand.position = Vector3.zero;
            return time;
        }

        public void Dispose()
        {
            if (hand != null) UnityEngine.Object.Destroy(hand.gameObject);
        }

        private void Begin(Scene scene)
        {
            var holder = new GameObject("SPH Fluid Physics Clock");
            SceneManager.MoveGameObjectToScene(holder, scene);
            holder.hideFlags = HideFlags.HideAndDontSave;
            hand = holder.AddComponent<Rigidbody>();
            (hand.useGravity, hand.sleepThreshold) = (false, 0f);
            hand.AddForce(Vector3.right, ForceMode.VelocityChange);
        }
    }
}

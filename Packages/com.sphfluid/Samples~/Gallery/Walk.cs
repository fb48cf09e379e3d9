using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>
    /// Turns this object from exhibit to exhibit, which stand round it. Only the one that it looks at is switched on, and the next while it
    /// turns there: a liquid that is switched off takes no time and no memory, and begins anew when it is switched on.
    /// </summary>
    public sealed class Walk : MonoBehaviour
    {
        [SerializeField, Tooltip("The exhibits in their order, each with its liquid.")]
        private GameObject[] exhibits;

        [SerializeField, Min(0.1f), Tooltip("Seconds before each.")]
        private float stay = 2.5f;

        [SerializeField, Min(0.1f), Tooltip("Seconds from one to the next.")]
        private float turn = 1f;

        private float time;

        private void Update()
        {
            time += Time.deltaTime;
            float round = time / (stay + turn);
            int here = (int)round % exhibits.Length, next = (here + 1) % exhibits.Length;
            float way = Mathf.SmoothStep(0f, 1f, ((round - (int)round) * (stay + turn) - stay) / turn);
            transform.rotation = Quaternion.Slerp(Towards(here), Towards(next), way);
            for (int i = 0; i < exhibits.Length; i++) exhibits[i].SetActive(i == here || i == next && way > 0f);
        }

        private Quaternion Towards(int exhibit)
        {
            Vector3 way = exhibits[exhibit].transform.position - transform.position;
            return Quaternion.LookRotation(new Vector3(way.x, 0f, way.z));
        }
    }
}

using System;
using UnityEngine;
using UnityEngine.Serialization;

namespace Ripples
{
    /// <summary>Waves on a square pool: a wave equation in one compute kernel, its colours in another, shown on this object's mesh.</summary>
    [RequireComponent(typeof(MeshRenderer))]
    public sealed class RipplePool : MonoBehaviour
    {
        [Serializable]
        public struct Palette
        {
            public Color trough;
            public Color rest;
            public Color crest;
        }

        [SerializeField] ComputeShader shader;
        [SerializeField] PoolSettings settings;
        [SerializeField, FormerlySerializedAs("size")] int resolution = 32;
        [SerializeField] Palette palette;
        [SerializeField] int stepsPerFrame = 1;

        static readonly int PictureId = Shader.PropertyToID("_Picture");

        ComputeBuffer past, present, future;
        RenderTexture picture;
        MaterialPropertyBlock block;
        int step, colourise;

        public int StepsDone { get; private set; }

        void OnEnable()
        {
            step = shader.FindKernel("Step");
            colourise = shader.FindKernel("Colourise");
            int cells = resolution * resolution;
            past = new ComputeBuffer(cells, sizeof(float));
            present = new ComputeBuffer(cells, sizeof(float));
            future = new ComputeBuffer(cells, sizeof(float));
            var heights = new float[cells];
            foreach (Vector2 drop in settings.drops)
                AddDrop(heights, drop);
            past.SetData(heights);
            present.SetData(heights);

            picture = new RenderTexture(resolution, resolution, 0, RenderTextureFormat.ARGB32, RenderTextureReadWrite.Linear);
            picture.enableRandomWrite = true;
            picture.filterMode = FilterMode.Point;
            picture.Create();
            block = new MaterialPropertyBlock();
            block.SetTexture(PictureId, picture);
            GetComponent<MeshRenderer>().SetPropertyBlock(block);
        }

        void Update()
        {
            shader.SetInt("_Resolution", resolution);
            shader.SetFloat("_Courant", settings.courant);
            shader.SetFloat("_Damping", settings.damping);
            shader.GetKernelThreadGroupSizes(step, out uint x, out uint y, out _);
            int groupsX = (resolution + (int)x - 1) / (int)x, groupsY = (resolution + (int)y - 1) / (int)y;
            for (int i = 0; i < stepsPerFrame; i++)
            {
                shader.SetBuffer(step, "_Past", past);
                shader.SetBuffer(step, "_Present", present);
                shader.SetBuffer(step, "_Future", future);
                shader.Dispatch(step, groupsX, groupsY, 1);
                (past, present, future) = (present, future, past);
                StepsDone++;
            }
        }

        void LateUpdate()
        {
            shader.GetKernelThreadGroupSizes(colourise, out uint x, out uint y, out _);
            shader.SetBuffer(colourise, "_Present", present);
            shader.SetTexture(colourise, "_Picture", picture);
            shader.SetVector("_Trough", palette.trough);
            shader.SetVector("_Rest", palette.rest);
            shader.SetVector("_Crest", palette.crest);
            shader.Dispatch(colourise, (resolution + (int)x - 1) / (int)x, (resolution + (int)y - 1) / (int)y, 1);
        }

        void OnDisable()
        {
            past?.Release();
            present?.Release();
            future?.Release();
            if (picture != null) picture.Release();
        }

        void AddDrop(float[] heights, Vector2 centre)
        {
            float radius = 0.08f * resolution;
            for (int y = 0; y < resolution; y++)
                for (int x = 0; x < resolution; x++)
                {
                    float dx = x + 0.5f - centre.x * resolution, dy = y + 0.5f - centre.y * resolution;
                    heights[y * resolution + x] += Mathf.Exp(-(dx * dx + dy * dy) / (radius * radius));
                }
        }
    }
}

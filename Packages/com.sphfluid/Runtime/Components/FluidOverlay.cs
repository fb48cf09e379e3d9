using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Shows in the corner of the screen what liquids do, in the Editor and in builds: particles, steps, times of the stages, what limits,
    /// messages. Drawn by OnGUI, so in every render pipeline. To switch it by a key or a button set <see cref="Visible"/>.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Overlay")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(120)]
    [ManualPage("diagnostics", "show-figures-on-the-screen")]
    public sealed class FluidOverlay : MonoBehaviour
    {
        private const float Margin = 8f;

        // The font's size is in pixels of a screen of this height, and grows on taller ones.
        private const float UsualHeight = 1080f;

        [SerializeField, Tooltip("Simulation to show. Empty: all that are enabled.")]
        private FluidSimulation simulation;

        [SerializeField, Tooltip("Whether it is shown. Switch it from a script, for example by a key.")]
        private bool visible = true;

        [SerializeField, Tooltip("Whether the times of the stages are measured and shown. They cover all liquids together.")]
        private bool stageTimes = true;

        [SerializeField, Range(0.5f, 30f),
            Tooltip("How often the text is refreshed, per second; figures are means over the time in between.")]
        private float refreshRate = 4f;

        [SerializeField, Range(8, 48), Tooltip("Size of the letters in pixels, on a screen of 1080 lines.")]
        private int fontSize = 14;

        [SerializeField, Tooltip("Corner of the screen where it is shown.")]
        private FluidOverlayCorner corner;

        private readonly GUIContent content = new GUIContent();
        private OverlayMeter meter;
        private GUIStyle style;
        private Vector2 size;
        private bool measured;

        /// <summary>Simulation that is shown; null: all that are enabled.</summary>
        public FluidSimulation Simulation { get => simulation; set => simulation = value; }

        /// <summary>Whether it is shown; while it is not, nothing is measured.</summary>
        public bool Visible { get => visible; set => visible = value; }

        /// <summary>Whether the times of the stages are measured and shown.</summary>
        public bool ShowsStageTimes { get => stageTimes; set => stageTimes = value; }

        /// <summary>Times a second that the text is written anew, 0.5 to 30.</summary>
        public float RefreshRate { get => Limits.Clamp(refreshRate, 0.5f, 30f); set => refreshRate = value; }

        /// <summary>Size of the letters in pixels on a screen of 1080 lines, 8 to 48.</summary>
        public int FontSize { get => Mathf.Clamp(fontSize, 8, 48); set => fontSize = value; }

        /// <summary>Corner of the screen where it is shown.</summary>
        public FluidOverlayCorner Corner { get => Limits.Known(corner); set => corner = value; }

        /// <summary>The text, for a display of your own: lines parted by '\n'; empty before the first and while not visible.</summary>
        public string Text => content.text;

        private void Awake() => useGUILayout = false;

        private void OnDisable() => Forget();

        private void LateUpdate()
        {
            if (!visible)
            {
                Forget();
                return;
            }
            meter ??= new OverlayMeter(StageTimes.Best);
            if (!meter.Update(simulation, Time.unscaledDeltaTime, 1.0 / RefreshRate, stageTimes)) return;
            content.text = meter.Text;
            measured = false;
        }

        private void OnGUI()
        {
            if (!visible || Event.current.type != EventType.Repaint || content.text.Length == 0) return;
            Prepare();
            Rect place = Place(Corner, size, new Vector2(Screen.width, Screen.height));
            GUI.DrawTexture(place, Texture2D.whiteTexture, ScaleMode.StretchToFill, true, 0f, new Color(0f, 0f, 0f, 0.6f), 0f, 0f);
            GUI.Label(new Rect(place.x + Margin, place.y + Margin, place.width - 2f * Margin, place.height - 2f * Margin), content, style);
        }

        private void Prepare()
        {
            int letters = Mathf.RoundToInt(FontSize * Mathf.Max(1f, Screen.height / UsualHeight));
            if (style == null) style = new GUIStyle { wordWrap = false, richText = false, normal = { textColor = Color.white } };
            if (measured && style.fontSize == letters) return;
            style.fontSize = letters;
            size = style.CalcSize(content) + 2f * Margin * Vector2.one;
            measured = true;
        }

        /// <summary>Where a box stands.</summary>
        internal static Rect Place(FluidOverlayCorner corner, Vector2 size, Vector2 screen)
        {
            float x = (int)corner % 2 == 0 ? Margin : screen.x - size.x - Margin,
                y = (int)corner / 2 == 0 ? Margin : screen.y - size.y - Margin;
            return new Rect(x, y, size.x, size.y);
        }

        private void Forget()
        {
            meter?.Dispose();
            meter = null;
            content.text = "";
        }
    }
}

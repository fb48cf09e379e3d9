using Headless.Engine;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class SceneTests : SceneFixture
{
    [Test]
    public void ALitCubeThrowsAShadowOnThePlane()
    {
        ScreenTarget.Resize(320, 240);
        Camera camera = Camera(new Vector3(3f, 3f, -5f), Vector3.zero);
        camera.clearFlags = CameraClearFlags.Skybox;
        Sun(new Vector3(-1f, -1.5f, 0.5f));
        Primitive(PrimitiveType.Plane, new Vector3(0f, -0.5f, 0f));
        Primitive(PrimitiveType.Cube, Vector3.zero, Color.red);
        Primitive(PrimitiveType.Sphere, new Vector3(1.6f, 0f, 1f), Color.green);
        Primitive(PrimitiveType.Capsule, new Vector3(-1.8f, 0.5f, 0f), Color.blue);
        Primitive(PrimitiveType.Cylinder, new Vector3(0f, 0.5f, 2f), Color.yellow);
        Frame();
        Picture picture = Picture.OfScreen().Keep("scene");

        // The plane to the left of the cube lies in its shadow, to the right in the sun.
        float shadow = picture.Brightness(camera.WorldToScreenPoint(new Vector3(-0.8f, -0.5f, 0.2f)));
        float lit = picture.Brightness(camera.WorldToScreenPoint(new Vector3(0.9f, -0.5f, -0.4f)));
        Assert.That(lit, Is.GreaterThan(shadow * 1.4f));
        Assert.That(lit, Is.GreaterThan(0.4f));

        // The side turned to the sun is brighter than the front, the top brighter still.
        float side = picture.Brightness(camera.WorldToScreenPoint(new Vector3(0.5f, 0f, 0f)));
        float front = picture.Brightness(camera.WorldToScreenPoint(new Vector3(0f, 0f, -0.5f)));
        float top = picture.Brightness(camera.WorldToScreenPoint(new Vector3(0f, 0.5f, 0f)));
        Assert.That(side, Is.GreaterThan(front));
        Assert.That(top, Is.GreaterThan(front));
        Assert.That(picture.Share(c => c.r > c.g * 2 && c.r > c.b * 2), Is.EqualTo(0.021f).Within(0.004f), "share of the red cube");
    }

    [Test]
    public void NearerThingsHideFartherOnesWhateverTheOrder()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        GameObject far = Flat(PrimitiveType.Cube, new Vector3(0f, 0f, 2f), Color.green);
        Flat(PrimitiveType.Cube, Vector3.zero, Color.red);
        far.transform.localScale = new Vector3(4f, 4f, 1f);
        far.GetComponent<Renderer>().sortingOrder = 5;
        Frame();
        Picture picture = Picture.OfScreen();
        Assert.That(IsRed(picture.At(64, 48)), Is.True);
        Assert.That(IsGreen(picture.At(64, 66)), Is.True);
        far.GetComponent<Renderer>().sortingOrder = -5;
        Frame();
        Assert.That(IsRed(Picture.OfScreen().At(64, 48)), Is.True);
        Assert.That(camera.WorldToScreenPoint(Vector3.zero).z, Is.EqualTo(5f).Within(1e-4f));
    }

    [Test]
    public void UpIsUpAndRightIsRight()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Flat(PrimitiveType.Cube, new Vector3(1.5f, 1f, 0f), Color.red);
        Frame();
        Picture screen = Picture.OfScreen();
        Vector3 point = camera.WorldToScreenPoint(new Vector3(1.5f, 1f, -0.5f));
        Assert.That(IsRed(screen.At(point)), Is.True);
        Assert.That(point.x, Is.GreaterThan(64f));
        Assert.That(point.y, Is.GreaterThan(48f));

        // The same into a texture, whose first row is the bottom.
        var texture = new RenderTexture(128, 96, 24);
        camera.targetTexture = texture;
        camera.Render();
        Picture picture = Picture.Of(texture);
        Assert.That(IsRed(picture.At(point)), Is.True);
        Assert.That(IsBlack(picture.At(new Vector3(point.x, 96f - point.y))), Is.True);
    }

    [Test]
    public void BackFacesAreCulledOnTheScreenInTexturesAndUnderMirroring()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -3f), Vector3.zero);
        GameObject quad = Flat(PrimitiveType.Quad, Vector3.zero, Color.red);
        var texture = new RenderTexture(128, 96, 24);
        foreach (bool mirrored in (bool[])[false, true])
        {
            quad.transform.localScale = new Vector3(mirrored ? -1f : 1f, 1f, 1f);
            foreach (float turn in (float[])[0f, 180f])
            {
                quad.transform.rotation = Quaternion.Euler(0f, turn, 0f);
                camera.targetTexture = null;
                Frame();
                Assert.That(IsRed(Picture.OfScreen().At(64, 48)), Is.EqualTo(turn == 0f), $"screen, {turn} degrees, mirrored {mirrored}");
                camera.targetTexture = texture;
                camera.Render();
                Assert.That(IsRed(Picture.Of(texture).At(64, 48)), Is.EqualTo(turn == 0f), $"texture, {turn} degrees, mirrored {mirrored}");
            }
        }
    }

    [Test]
    public void TwoMaterialsOfOneShaderKeepTheirOwnColors()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Shader shader = ShaderOf(FlatShader);
        var red = new Material(shader) { color = Color.red };
        var green = new Material(shader);
        green.SetColor("_Color", Color.green);
        GameObject left = GameObject.CreatePrimitive(PrimitiveType.Cube);
        left.transform.position = new Vector3(-1f, 0f, 0f);
        left.GetComponent<Renderer>().sharedMaterial = red;
        GameObject right = GameObject.CreatePrimitive(PrimitiveType.Cube);
        right.transform.position = new Vector3(1f, 0f, 0f);
        right.GetComponent<Renderer>().sharedMaterial = green;
        Frame();
        Picture picture = Picture.OfScreen();
        Assert.That(picture.Share(IsRed), Is.GreaterThan(0.025f));
        Assert.That(picture.Share(IsGreen), Is.EqualTo(picture.Share(IsRed)).Within(0.002f));

        // A property block on one renderer changes neither material.
        var block = new MaterialPropertyBlock();
        block.SetColor("_Color", Color.green);
        left.GetComponent<Renderer>().SetPropertyBlock(block);
        Frame();
        Assert.That(Picture.OfScreen().Share(IsRed), Is.Zero);
        Assert.That(red.color, Is.EqualTo(Color.red));
    }

    [Test]
    public void LayersAndCameraOrder()
    {
        Camera first = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        GameObject cube = Flat(PrimitiveType.Cube, Vector3.zero, Color.red);
        cube.layer = 4;
        first.cullingMask = ~(1 << 4);
        Frame();
        Assert.That(Picture.OfScreen().Share(IsRed), Is.Zero);

        // A second camera of greater depth draws over the first without clearing its colors.
        first.backgroundColor = Color.green;
        Camera second = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        second.clearFlags = CameraClearFlags.Depth;
        second.depth = 1f;
        Frame();
        Picture picture = Picture.OfScreen();
        Assert.That(IsRed(picture.At(64, 48)), Is.True);
        Assert.That(IsGreen(picture.At(4, 4)), Is.True);
    }

    [Test]
    public void PartOfTheScreen()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        camera.backgroundColor = Color.green;
        Camera inset = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        inset.backgroundColor = Color.red;
        inset.depth = 1f;
        inset.rect = new Rect(0.5f, 0.5f, 0.5f, 0.5f);
        Frame();
        Picture picture = Picture.OfScreen();
        Assert.That(IsRed(picture.At(100, 80)), Is.True, "top right");
        Assert.That(IsGreen(picture.At(100, 20)), Is.True, "bottom right");
        Assert.That(IsGreen(picture.At(20, 80)), Is.True, "top left");
        Assert.That(picture.Share(IsRed), Is.EqualTo(0.25f).Within(0.01f));
    }

    [Test]
    public void TransparentThingsAreDrawnFromBackToFront()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        foreach ((float z, Color color) in ((float, Color)[])[(-1f, new Color(0f, 1f, 0f, 0.5f)), (1f, new Color(1f, 0f, 0f, 0.5f))])
        {
            GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            quad.transform.position = new Vector3(0f, 0f, z);
            quad.transform.localScale = new Vector3(4f, 4f, 1f);
            Material material = MaterialOf(FlatShader.Replace("Pass\n", "Tags { \"Queue\" = \"Transparent\" } Pass\n").Replace("HLSLPROGRAM", "Blend SrcAlpha OneMinusSrcAlpha ZWrite Off\nHLSLPROGRAM"));
            material.SetColor("_Color", color);
            quad.GetComponent<Renderer>().sharedMaterial = material;
        }

        Frame();

        // Green over red over black: linear (0.25, 0.5, 0), which is sRGB (137, 188, 0).
        Color32 middle = Picture.OfScreen().At(64, 48);
        Assert.That(middle.r, Is.EqualTo(137).Within(2));
        Assert.That(middle.g, Is.EqualTo(188).Within(2));
    }

    [Test]
    public void BrokenShadersAreMagenta()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
        cube.GetComponent<Renderer>().sharedMaterial = MaterialOf(FlatShader.Replace("return _Color;", "return nothing;"));
        Frame();
        Color32 middle = Picture.OfScreen().At(64, 48);
        Assert.That((middle.r, middle.g, middle.b), Is.EqualTo(((byte)255, (byte)0, (byte)255)));
        Assert.That(TakeErrors(), Has.Some.Contains("Shader error in"));
    }
}

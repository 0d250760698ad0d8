package org.sami.ui.map;

import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;

/** A device whose images count what is painted into them. */
final class CountingConfiguration extends GraphicsConfiguration {
    private final GraphicsConfiguration target;
    private final PaintingWork work;

    CountingConfiguration(GraphicsConfiguration target, PaintingWork work) {
        this.target = target;
        this.work = work;
    }

    @Override
    public BufferedImage createCompatibleImage(int width, int height) {
        return new CountedImage(width, height, BufferedImage.TYPE_INT_RGB);
    }

    @Override
    public BufferedImage createCompatibleImage(int width, int height, int transparency) {
        return new CountedImage(
                width, height, transparency == OPAQUE ? BufferedImage.TYPE_INT_RGB : BufferedImage.TYPE_INT_ARGB);
    }

    private static final int OPAQUE = java.awt.Transparency.OPAQUE;

    private final class CountedImage extends BufferedImage {
        CountedImage(int width, int height, int type) {
            super(width, height, type);
        }

        @Override
        public Graphics2D createGraphics() {
            return new CountingGraphics(super.createGraphics(), work);
        }
    }

    @Override
    public GraphicsDevice getDevice() {
        return target.getDevice();
    }

    @Override
    public ColorModel getColorModel() {
        return target.getColorModel();
    }

    @Override
    public ColorModel getColorModel(int transparency) {
        return target.getColorModel(transparency);
    }

    @Override
    public AffineTransform getDefaultTransform() {
        return target.getDefaultTransform();
    }

    @Override
    public AffineTransform getNormalizingTransform() {
        return target.getNormalizingTransform();
    }

    @Override
    public Rectangle getBounds() {
        return target.getBounds();
    }
}

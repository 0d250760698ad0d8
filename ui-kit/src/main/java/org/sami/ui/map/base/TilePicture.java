package org.sami.ui.map.base;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/** The picture of a tile, of which nothing is decoded before its size is known, in the pixels that a screen copies quickly. */
final class TilePicture {
    private static final int MOST_PX = 2 * TileKey.PX;

    private TilePicture() {}

    /**
     * Reads a picture.
     *
     * @param which names the tile in messages
     * @throws IOException if it is no picture, or a very large one
     */
    static BufferedImage read(byte[] bytes, String which) throws IOException {
        try (ImageInputStream in = ImageIO.createImageInputStream(new ByteArrayInputStream(bytes))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext()) {
                throw new IOException(which + " is no picture");
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(in, true, true);
                int width = side(reader, which, true);
                int height = side(reader, which, false);
                if (width > MapFileLimits.TILE_SIDE_PX || height > MapFileLimits.TILE_SIDE_PX) {
                    throw new IOException(which + " has " + width + " by " + height + " pixels, more than "
                            + MapFileLimits.TILE_SIDE_PX + ", and is left out");
                }
                return plain(decoded(reader, which));
            } finally {
                reader.dispose();
            }
        }
    }

    private static int side(ImageReader reader, String which, boolean isWidth) throws IOException {
        try {
            return isWidth ? reader.getWidth(0) : reader.getHeight(0);
        } catch (IOException | RuntimeException broken) {
            throw new IOException(which + " is a broken picture: " + MapFileLimits.cut(broken.toString(), 200), broken);
        }
    }

    private static BufferedImage decoded(ImageReader reader, String which) throws IOException {
        try {
            return reader.read(0);
        } catch (IOException | RuntimeException broken) { // readers of pictures throw many kinds for one that is broken
            throw new IOException(which + " is a broken picture: " + MapFileLimits.cut(broken.toString(), 200), broken);
        }
    }

    private static BufferedImage plain(BufferedImage picture) {
        int width = Math.min(MOST_PX, picture.getWidth());
        int height = Math.min(MOST_PX, picture.getHeight());
        BufferedImage plain = new BufferedImage(
                width,
                height,
                picture.getColorModel().hasAlpha() ? BufferedImage.TYPE_INT_ARGB_PRE : BufferedImage.TYPE_INT_RGB);
        Graphics2D g = plain.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        g.drawImage(picture, 0, 0, width, height, null);
        g.dispose();
        return plain;
    }
}

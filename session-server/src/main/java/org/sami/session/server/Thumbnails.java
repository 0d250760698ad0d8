package org.sami.session.server;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.sami.picture.photo.PhotoReader;

/** Small JPEGs of pictures, of at most {@value #MOST_BYTES} bytes; the latest that were asked for are kept. For one thread. */
final class Thumbnails {
    static final int MOST_BYTES = 30_000;

    private static final int WIDTH_PX = 320;
    private static final int HEIGHT_PX = 240;
    private static final float[] QUALITIES = {0.8f, 0.6f, 0.4f, 0.2f, 0.05f};
    private static final int MOST_KEPT = 200;

    private final Map<Path, byte[]> kept = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Path, byte[]> eldest) {
            return size() > MOST_KEPT;
        }
    };

    /** A small JPEG of a picture's file; empty where that cannot be read as a picture. */
    Optional<byte[]> of(Path file) {
        byte[] known = kept.get(file);
        if (known != null) {
            return Optional.of(known);
        }
        Optional<BufferedImage> image =
                PhotoReader.read(file, WIDTH_PX, HEIGHT_PX).image().map(Thumbnails::opaque);
        if (image.isEmpty()) {
            return Optional.empty();
        }
        for (float quality : QUALITIES) {
            byte[] made = jpeg(image.get(), quality);
            if (made.length <= MOST_BYTES) {
                kept.put(file, made);
                return Optional.of(made);
            }
        }
        return Optional.empty();
    }

    /** JPEG has no clear pixels. */
    private static BufferedImage opaque(BufferedImage image) {
        BufferedImage opaque = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = opaque.createGraphics();
        g.drawImage(image, 0, 0, null);
        g.dispose();
        return opaque;
    }

    private static byte[] jpeg(BufferedImage image, float quality) {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
            ImageWriteParam how = writer.getDefaultWriteParam();
            how.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            how.setCompressionQuality(quality);
            writer.setOutput(out);
            writer.write(null, new IIOImage(image, null, null), how);
        } catch (IOException inMemory) {
            throw new IllegalStateException("a picture is written into memory", inMemory);
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }
}

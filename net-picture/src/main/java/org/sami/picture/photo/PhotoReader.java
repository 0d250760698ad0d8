package org.sami.picture.photo;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Locale;
import java.util.Set;
import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.FileImageInputStream;
import javax.imageio.stream.ImageInputStream;

/**
 * Reads JPEG and PNG files of cameras. For any other content the result is a line of text and not an exception: no picture, a picture that is cut off, or one
 * with more bytes or pixels than a window needs. The size is checked before anything is decoded. Reads a disk, so not for the event thread; safe for several
 * threads.
 */
public final class PhotoReader {
    /** Most bytes of a file that is read. */
    public static final long MOST_BYTES = 32L << 20;

    /** Most pixels of a picture that is decoded: those of a large phone camera. */
    public static final long MOST_PIXELS = 64_000_000;

    private static final Set<String> FORMATS = Set.of("jpeg", "png");

    private PhotoReader() {}

    /**
     * Reads a picture so that it fits into a box, never larger than it is.
     *
     * @param file that may be anything
     * @param widthPx of the box
     * @param heightPx of the box
     */
    public static Photo read(Path file, int widthPx, int heightPx) {
        String name = String.valueOf(file.getFileName());
        try {
            long bytes = Files.size(file);
            if (bytes > MOST_BYTES) {
                return Photo.none(name + " has " + bytes + " bytes, more than the " + MOST_BYTES + " that are shown");
            }
            try (ImageInputStream in = new FileImageInputStream(file.toFile())) {
                return read(name, in, Math.max(1, widthPx), Math.max(1, heightPx));
            }
        } catch (NoSuchFileException | java.io.FileNotFoundException e) {
            return Photo.none(name + " is no longer in the folder of the session");
        } catch (IOException | RuntimeException e) { // decoders throw many kinds
            return Photo.none(name + " cannot be shown: " + words(e));
        }
    }

    private static String words(Exception fault) {
        if (fault instanceof IIOException || fault instanceof RuntimeException) {
            return "its content is damaged";
        }
        return fault.getMessage() == null ? fault.toString() : fault.getMessage();
    }

    private static Photo read(String name, ImageInputStream in, int widthPx, int heightPx) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
        while (readers.hasNext()) {
            ImageReader reader = readers.next();
            try {
                if (FORMATS.contains(reader.getFormatName().toLowerCase(Locale.ROOT))) {
                    reader.setInput(in, true, true);
                    return read(name, reader, widthPx, heightPx);
                }
            } finally {
                reader.dispose();
            }
        }
        return Photo.none(name + " is no picture");
    }

    private static Photo read(String name, ImageReader reader, int widthPx, int heightPx) throws IOException {
        int width = reader.getWidth(0);
        int height = reader.getHeight(0);
        if ((long) width * height > MOST_PIXELS) {
            return Photo.none(name + " has " + width + " × " + height + " pixels, more than are shown");
        }
        double scale = Math.min(1, Math.min(widthPx / (double) width, heightPx / (double) height));
        int step =
                Math.max(1, (int) Math.floor(0.5 / scale)); // twice as many pixels as are needed, for a smooth picture
        ImageReadParam every = reader.getDefaultReadParam();
        every.setSourceSubsampling(step, step, 0, 0);
        boolean[] warned = {false};
        reader.addIIOReadWarningListener((source, warning) -> warned[0] = true);
        BufferedImage read = reader.read(0, every);
        if (warned[0]) {
            return Photo.none(name + " is cut off or damaged");
        }
        int toWidth = Math.max(1, (int) Math.round(width * scale));
        int toHeight = Math.max(1, (int) Math.round(height * scale));
        return Photo.of(scaled(read, toWidth, toHeight), width, height);
    }

    private static BufferedImage scaled(BufferedImage image, int width, int height) {
        BufferedImage scaled = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D to = scaled.createGraphics();
        try {
            to.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
            to.drawImage(image, 0, 0, width, height, null);
        } finally {
            to.dispose();
        }
        return scaled;
    }
}

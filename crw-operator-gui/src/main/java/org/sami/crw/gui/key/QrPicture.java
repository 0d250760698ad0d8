package org.sami.crw.gui.key;

import com.google.zxing.BinaryBitmap;
import com.google.zxing.DecodeHintType;
import com.google.zxing.LuminanceSource;
import com.google.zxing.RGBLuminanceSource;
import com.google.zxing.ReaderException;
import com.google.zxing.common.HybridBinarizer;
import com.google.zxing.qrcode.QRCodeReader;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.imageio.IIOException;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/** Reads the QR code in a picture file: a photo of a phone, or its screenshot. Takes up to seconds: not for the event thread. */
final class QrPicture {
    private static final long MOST_BYTES = 40L << 20;
    private static final long MOST_PIXELS = 200_000_000;
    private static final List<Integer> SIDES = List.of(1000, 2000, 600); // a photo is read better where it is smaller

    private QrPicture() {}

    /**
     * The text of the code in a picture.
     *
     * @throws IOException in one sentence, if the file is no picture, is too large, or no code is found in it
     */
    static String read(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new IOException("there is no file " + file);
        }
        if (Files.size(file) > MOST_BYTES) {
            throw new IOException(file.getFileName() + " is too large for a picture of a QR code: more than "
                    + (MOST_BYTES >> 20) + " MB");
        }
        for (int side : SIDES) {
            BufferedImage picture = picture(file, side);
            Optional<String> found = find(picture);
            if (found.isPresent()) {
                return found.get();
            }
        }
        throw new IOException("no QR code is found in " + file.getFileName()
                + ": take the picture straight from the front, with the whole code in it");
    }

    private static BufferedImage picture(Path file, int side) throws IOException {
        try (ImageInputStream in = ImageIO.createImageInputStream(new File(file.toString()))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext()) {
                throw new IOException(file.getFileName() + " is no picture that can be read: PNG, JPEG, GIF or BMP");
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(in);
                long pixels = (long) reader.getWidth(0) * reader.getHeight(0);
                if (pixels > MOST_PIXELS) {
                    throw new IOException(file.getFileName() + " has too many pixels: " + pixels);
                }
                ImageReadParam param = reader.getDefaultReadParam();
                int every = Math.max(1, Math.max(reader.getWidth(0), reader.getHeight(0)) / side);
                param.setSourceSubsampling(every, every, 0, 0);
                return reader.read(0, param);
            } catch (IIOException | RuntimeException damaged) { // of pictures that are cut or forged
                throw new IOException(file.getFileName() + " is damaged: " + damaged.getMessage(), damaged);
            } finally {
                reader.dispose();
            }
        }
    }

    private static Optional<String> find(BufferedImage picture) {
        int width = picture.getWidth();
        int height = picture.getHeight();
        LuminanceSource light =
                new RGBLuminanceSource(width, height, picture.getRGB(0, 0, width, height, null, 0, width));
        return decode(light).or(() -> decode(light.invert())); // a terminal with light letters shows it inverted
    }

    private static Optional<String> decode(LuminanceSource light) {
        try {
            return Optional.of(new QRCodeReader()
                    .decode(
                            new BinaryBitmap(new HybridBinarizer(light)),
                            Map.of(DecodeHintType.TRY_HARDER, Boolean.TRUE))
                    .getText());
        } catch (ReaderException none) {
            return Optional.empty();
        }
    }
}

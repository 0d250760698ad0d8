package org.sami.crw.gui.key;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.cli.key.QrCode;

/** The QR code in a picture: straight, turned, noisy, inverted, large; and what is no such picture. */
class QrPictureTest {
    private static final String TEXT = "SAMI1;192.168.43.7:5001;n4bQgYhMfWWaL-qgxVrQFaO_TxsrC4Is0V1sFbDwCgg;"
            + "able.abou.abov.abse.abso.acce;anna";

    @TempDir
    private Path folder;

    private Path picture(int width, int height, double module, double turnDeg, int noise, boolean inverted, String type)
            throws IOException {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(inverted ? Color.DARK_GRAY : Color.LIGHT_GRAY);
        g.fillRect(0, 0, width, height);
        QrCode code = QrCode.of(TEXT);
        AffineTransform place = AffineTransform.getTranslateInstance(width / 2.0, height / 2.0);
        place.rotate(Math.toRadians(turnDeg));
        place.scale(module, module);
        place.translate(-code.size() / 2.0, -code.size() / 2.0);
        g.transform(place);
        for (int row = -QrCode.QUIET; row < code.size() + QrCode.QUIET; row++) {
            for (int column = -QrCode.QUIET; column < code.size() + QrCode.QUIET; column++) {
                g.setColor(code.isDark(column, row) != inverted ? Color.BLACK : Color.WHITE);
                g.fillRect(column, row, 1, 1);
            }
        }
        g.dispose();
        Random chance = new Random(7);
        for (int y = 0; y < height && noise > 0; y++) {
            for (int x = 0; x < width; x++) {
                Color at = new Color(image.getRGB(x, y));
                int grey = Math.max(0, Math.min(255, at.getRed() + chance.nextInt(2 * noise) - noise));
                image.setRGB(x, y, new Color(grey, grey, grey).getRGB());
            }
        }
        Path file = folder.resolve("picture." + type);
        ImageIO.write(image, type, file.toFile());
        return file;
    }

    @ParameterizedTest
    @CsvSource({
        "400, 400, 6, 0, 0, false, png",
        "1080, 2340, 20, 0, 0, false, png",
        "1280, 960, 9, 8, 40, false, jpg",
        "4000, 3000, 30, -5, 30, false, jpg",
        "600, 500, 8, 90, 0, true, png"
    })
    void codeIsRead(int width, int height, double module, double turn, int noise, boolean inverted, String type)
            throws IOException {
        assertThat(QrPicture.read(picture(width, height, module, turn, noise, inverted, type)))
                .isEqualTo(TEXT);
    }

    @Test
    void whatHasNoCodeIsNamed() throws IOException {
        Path empty = folder.resolve("empty.png");
        ImageIO.write(new BufferedImage(300, 200, BufferedImage.TYPE_INT_RGB), "png", empty.toFile());
        Path text = Files.writeString(folder.resolve("notes.png"), "no picture");
        Path cut = picture(400, 400, 6, 0, 0, false, "png");
        byte[] whole = Files.readAllBytes(cut);
        Files.write(cut, Arrays.copyOf(whole, whole.length / 3));

        refused(empty, "no QR code is found in empty.png");
        refused(text, "notes.png is no picture that can be read");
        refused(cut, "picture.png is damaged");
        refused(folder.resolve("missing.png"), "there is no file");
    }

    @Test
    void pictureOfTwoHundredMegabytesIsRefusedUnread() throws IOException {
        Path large = folder.resolve("large.png");
        try (RandomAccessFile file = new RandomAccessFile(large.toFile(), "rw")) {
            file.setLength(200L << 20); // sparse: no disk is used
        }

        refused(large, "large.png is too large for a picture of a QR code: more than 40 MB");
    }

    private static void refused(Path file, String why) {
        assertThatThrownBy(() -> QrPicture.read(file))
                .isInstanceOf(IOException.class)
                .hasMessageContaining(why);
    }
}

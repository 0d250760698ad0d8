package org.sami.picture.photo;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import java.util.zip.DeflaterOutputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever a file holds is a picture within the box, or a line of text. */
class PhotoReaderTest {
    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void name() {
        file = folder.resolve("a.jpg");
    }

    private byte[] picture(String format) throws IOException {
        BufferedImage image = new BufferedImage(640, 360, BufferedImage.TYPE_INT_RGB);
        Graphics2D to = image.createGraphics();
        to.setColor(Color.RED);
        to.fillRect(0, 0, 320, 360);
        to.dispose();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, format, bytes);
        return bytes.toByteArray();
    }

    @ParameterizedTest
    @ValueSource(strings = {"jpeg", "png"})
    void pictureFitsIntoTheBoxAndKeepsItsShape(String format) throws IOException {
        Files.write(file, picture(format));

        Photo small = PhotoReader.read(file, 100, 100);

        assertThat(small.image()).hasValueSatisfying(image -> {
            assertThat(image.getWidth()).isEqualTo(100);
            assertThat(image.getHeight()).isEqualTo(56);
            assertThat(new Color(image.getRGB(20, 28)).getRed()).isGreaterThan(200);
            assertThat(new Color(image.getRGB(80, 28)).getRed()).isLessThan(50);
        });
        assertThat(small.widthPx()).isEqualTo(640);
        assertThat(PhotoReader.read(file, 5000, 5000).image().orElseThrow().getWidth())
                .isEqualTo(640);
    }

    @Test
    void pictureThatIsCutOffIsToldAsDamaged() throws IOException {
        byte[] whole = picture("jpeg");
        for (int length = 0; length < whole.length - 2; length += whole.length / 40) {
            Files.write(file, Arrays.copyOf(whole, length));

            assertThat(PhotoReader.read(file, 100, 100).problem())
                    .as("%s of %s bytes", length, whole.length)
                    .startsWith("a.jpg ");
        }
    }

    @Test
    void anyDamageIsAPictureOrALineOfText() throws IOException {
        SplittableRandom random = new SplittableRandom(5);
        for (int round = 0; round < 300; round++) {
            byte[] damaged = picture(round % 2 == 0 ? "jpeg" : "png");
            for (int i = 0; i < 8; i++) {
                damaged[random.nextInt(damaged.length)] = (byte) random.nextInt(256);
            }
            Files.write(file, damaged);

            Photo photo = PhotoReader.read(file, 64, 64);
            assertThat(photo.image().isPresent()).isEqualTo(photo.problem().isEmpty());
        }
    }

    @Test
    void whatIsNoPictureIsToldSo() throws IOException {
        Files.writeString(file, "<html>no picture</html>");
        assertThat(PhotoReader.read(file, 100, 100).problem()).isEqualTo("a.jpg is no picture");

        assertThat(PhotoReader.read(folder.resolve("b.jpg"), 100, 100).problem())
                .isEqualTo("b.jpg is no longer in the folder of the session");
    }

    @Test
    void bombOfPixelsIsRefusedByItsSize() throws IOException {
        Files.write(file, bomb(50_000, 50_000));

        assertThat(PhotoReader.read(file, 100, 100).problem())
                .isEqualTo("a.jpg has 50000 × 50000 pixels, more than are shown");
    }

    @Test
    void fileOfTooManyBytesIsNotRead() throws IOException {
        try (RandomAccessFile large = new RandomAccessFile(file.toFile(), "rw")) {
            large.setLength(200_000_000);
        }

        assertThat(PhotoReader.read(file, 100, 100).problem())
                .isEqualTo("a.jpg has 200000000 bytes, more than the 33554432 that are shown");
    }

    /** A small PNG file whose picture would take gigabytes. */
    private static byte[] bomb(int width, int height) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(new byte[] {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10});
        ByteArrayOutputStream header = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(header);
        out.writeInt(width);
        out.writeInt(height);
        out.write(new byte[] {1, 0, 0, 0, 0});
        chunk(bytes, "IHDR", header.toByteArray());
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream zip = new DeflaterOutputStream(packed)) {
            zip.write(new byte[1 << 20]);
        }
        chunk(bytes, "IDAT", packed.toByteArray());
        chunk(bytes, "IEND", new byte[0]);
        return bytes.toByteArray();
    }

    private static void chunk(ByteArrayOutputStream to, String type, byte[] content) throws IOException {
        DataOutputStream out = new DataOutputStream(to);
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        CRC32 check = new CRC32();
        check.update(name);
        check.update(content);
        out.writeInt(content.length);
        out.write(name);
        out.write(content);
        out.writeInt((int) check.getValue());
    }
}

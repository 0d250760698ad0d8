package org.sami.crw.cli.key;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.zxing.BinaryBitmap;
import com.google.zxing.RGBLuminanceSource;
import com.google.zxing.common.HybridBinarizer;
import com.google.zxing.qrcode.QRCodeReader;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A QR code in a terminal: what its half blocks show is read as the text. */
class QrCodeTest {
    private static final String TEXT = "SAMI1;192.168.43.7:5001;n4bQgYhMfWWaL-qgxVrQFaO_TxsrC4Is0V1sFbDwCgg;"
            + "able.abou.abov.abse.abso.acce;anna";
    private static final int PIXELS = 4;

    @Test
    void halfBlocksOfATerminalAreReadAsTheText() throws Exception {
        List<String> lines = QrCode.of(TEXT).halfBlocks(false).lines().toList();
        int width = lines.get(0).length() * PIXELS;
        int height = lines.size() * 2 * PIXELS;
        int[] pixels = new int[width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                char half = lines.get(y / PIXELS / 2).charAt(x / PIXELS);
                boolean upper = y / PIXELS % 2 == 0;
                boolean dark = half == '█' || half == (upper ? '▀' : '▄');
                pixels[y * width + x] = dark ? 0 : 0xffffff;
            }
        }

        String read = new QRCodeReader()
                .decode(new BinaryBitmap(new HybridBinarizer(new RGBLuminanceSource(width, height, pixels))))
                .getText();

        assertThat(read).isEqualTo(TEXT);
    }

    @Test
    void pairingCodeFitsIntoATerminalOfEightyColumns() {
        List<String> lines = QrCode.of(TEXT).halfBlocks(false).lines().toList();

        assertThat(lines)
                .hasSizeLessThanOrEqualTo(24)
                .allSatisfy(line -> assertThat(line.length()).isLessThanOrEqualTo(80));
    }

    @Test
    void coloursOfTheTerminalAreSetAndTakenBackOnEachLine() {
        assertThat(QrCode.of(TEXT).halfBlocks(true).lines())
                .allSatisfy(line ->
                        assertThat(line).startsWith("\u001b[38;5;16;48;5;231m").endsWith("\u001b[0m"));
    }
}

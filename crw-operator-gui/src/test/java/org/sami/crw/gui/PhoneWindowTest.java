package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_A;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_SPACE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.google.zxing.BinaryBitmap;
import com.google.zxing.RGBLuminanceSource;
import com.google.zxing.ReaderException;
import com.google.zxing.common.HybridBinarizer;
import com.google.zxing.qrcode.QRCodeReader;
import java.awt.image.BufferedImage;
import java.net.ConnectException;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Pair;
import org.sami.boat.link.Paired;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.proxy.phone.OwnNetwork;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.sheet.WindowSheet;

/** A phone scans the code that the window shows, and is paired by keys of the keyboard alone; nothing is served once the sheet is closed. */
@Tag("window")
@Timeout(900)
@Isolated("what --keys says holds for the whole process")
class PhoneWindowTest {
    @TempDir
    private Path folder;

    private OpenedWindow opened;
    private final Identity phone = Identity.generate();
    private WindowRobot robot;
    private OperatorWindow window;

    @BeforeEach
    void open() throws Exception {
        RealDisplay.assumed();
        assumeFalse(OwnNetwork.all().isEmpty(), "this machine is in no network");
        robot = new WindowRobot();
        opened = OpenedWindow.byCommand(List.of(
                "--keys",
                folder.resolve("keys").toString(),
                "--data",
                folder.resolve("data").toString(),
                "--no-resume"));
        window = opened.window();
        robot.untilSaid("boats-count", "5 of 5");
    }

    @AfterEach
    void close() throws Exception {
        new BaseProtection(Optional.empty(), false).use();
        if (opened != null) {
            opened.end();
        }
    }

    private String said() {
        return SessionWorld.text(window.frame(), "phone-said");
    }

    /** What is on the screen as a code, as a camera would see it: it looks until there is one that it can read. */
    private String scanned() {
        robot.until("the code is shown", () -> {
            String text = WindowRobot.ask(() -> robot.find(JComponent.class, "phone-code")
                    .getAccessibleContext()
                    .getAccessibleDescription());
            return text != null && text.startsWith("http://");
        });
        List<String> read = new ArrayList<>();
        robot.until("a QR code that can be read", () -> {
            picture().flatMap(PhoneWindowTest::read).ifPresent(read::add);
            return !read.isEmpty();
        });
        return read.get(0);
    }

    /** Empty while the sheet is laid out. */
    private Optional<BufferedImage> picture() {
        return WindowRobot.ask(() -> {
            JComponent code = robot.find(JComponent.class, "phone-code");
            if (code.getWidth() == 0 || code.getHeight() == 0) {
                return Optional.empty();
            }
            BufferedImage painted = new BufferedImage(code.getWidth(), code.getHeight(), BufferedImage.TYPE_INT_RGB);
            code.paint(painted.getGraphics());
            return Optional.of(painted);
        });
    }

    private static Optional<String> read(BufferedImage picture) {
        int[] pixels = picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
        try {
            return Optional.of(new QRCodeReader()
                    .decode(new BinaryBitmap(new HybridBinarizer(
                            new RGBLuminanceSource(picture.getWidth(), picture.getHeight(), pixels))))
                    .getText());
        } catch (ReaderException notYet) {
            return Optional.empty();
        }
    }

    private LinkMessage pair(String scanned) throws Exception {
        PairingCode code = PairingCode.parse(scanned.split("#", 2)[1]);
        BoatAddress at = BoatAddress.parse(code.address());
        try (Socket socket = new Socket(at.host(), at.port())) {
            SecureLink link = TlsLinks.toPair(phone).connect(socket);
            Pair asked = new Pair("boat-1234", code.words().proofOfBoat(code.key(), phone.fingerprint()));
            link.out().write(LinkCodec.STANDARD.encode(0, asked));
            return LinkCodec.STANDARD
                    .decode(new FrameReader(link.in(), LinkCodec.STANDARD)
                            .next()
                            .orElseThrow())
                    .message();
        }
    }

    private static int page(String scanned) throws Exception {
        return HttpClient.newHttpClient()
                .send(
                        HttpRequest.newBuilder(URI.create(scanned.split("#", 2)[0]))
                                .build(),
                        BodyHandlers.discarding())
                .statusCode();
    }

    private boolean isOpen() {
        return WindowSheet.find(window.frame().getRootPane())
                .filter(one -> one.name().equals("phone-sheet"))
                .isPresent();
    }

    @Test
    void phoneThatScansTheScreenIsPairedAndNothingIsServedAfterwards() throws Exception {
        robot.press(VK_A, VK_ALT, VK_SHIFT);
        robot.untilShown("phone-sheet");
        String scanned = scanned();
        assertThat(page(scanned)).isEqualTo(200);

        assertThat(pair(scanned)).isInstanceOf(Paired.class);
        robot.untilFocused("pair-same");
        Fingerprint base =
                new KeyStoreFolder(folder.resolve("keys")).open().identity().fingerprint();
        assertThat(robot.find(JLabel.class, "pair-code").getText())
                .isEqualTo(PairingSecret.checkCode(base, phone.fingerprint()));
        assertThat(said()).isEqualTo("Does boat-1234 show the same check code?");
        robot.press(VK_SPACE);
        robot.until("it is paired", () -> said().startsWith("✓ Paired with boat-1234"));
        assertThat(new KeyStoreFolder(folder.resolve("keys")).open().find(phone.fingerprint()))
                .isPresent();
        assertThat(scanned()).as("the next phone gets another code").isNotEqualTo(scanned);

        robot.press(VK_ESCAPE);
        robot.until("the sheet is closed", () -> !isOpen());
        robot.until("nothing is served", () -> {
            try {
                page(scanned);
                return false;
            } catch (ConnectException refused) {
                return true;
            } catch (Exception other) {
                throw new AssertionError(other);
            }
        });
        assertThatThrownBy(() -> pair(scanned)).isInstanceOf(ConnectException.class);
    }
}

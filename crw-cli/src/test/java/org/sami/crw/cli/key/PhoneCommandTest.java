package org.sami.crw.cli.key;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.ConnectException;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Pair;
import org.sami.boat.link.Paired;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.output.ErrorMessages;
import org.sami.crw.proxy.tcp.BoatAddress;
import picocli.CommandLine;

/** {@code crw phone} with a person who answers, and a phone on loopback. */
@Timeout(900)
class PhoneCommandTest {
    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();
    private final Identity phone = Identity.generate();

    private CompletableFuture<Integer> begin(InputStream input, String... more) {
        CommandLine command = new CommandLine(new PhoneCommand(input))
                .setOut(new PrintWriter(out, true))
                .setErr(new PrintWriter(err, true))
                .setExecutionExceptionHandler(ErrorMessages::onException);
        String[] args = new String[more.length + 4];
        args[0] = "--address";
        args[1] = "127.0.0.1";
        args[2] = "--keys";
        args[3] = folder.resolve("keys").toString();
        System.arraycopy(more, 0, args, 4, more.length);
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        Thread thread = new Thread(() -> ended.complete(command.execute(args)), "crw phone");
        thread.setDaemon(true);
        thread.start();
        return ended;
    }

    private String shown() {
        Await.until("the code is shown", () -> out.toString().contains("Ctrl-C ends it."));
        return out.toString()
                .lines()
                .filter(line -> line.startsWith("http://"))
                .findFirst()
                .orElseThrow();
    }

    private LinkMessage pair(String shown) throws Exception {
        PairingCode code = PairingCode.parse(shown.split("#", 2)[1]);
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

    private int page(String shown) throws IOException, InterruptedException {
        HttpRequest request =
                HttpRequest.newBuilder(URI.create(shown.split("#", 2)[0])).build();
        return HttpClient.newHttpClient()
                .send(request, BodyHandlers.discarding())
                .statusCode();
    }

    private boolean knowsThePhone() throws IOException {
        return new KeyStoreFolder(folder.resolve("keys"))
                .open()
                .find(phone.fingerprint())
                .isPresent();
    }

    @Test
    void phoneIsPairedByAYesAndNothingIsServedAfterwards() throws Exception {
        try (PipedOutputStream person = new PipedOutputStream();
                PipedInputStream input = new PipedInputStream(person)) {
            CompletableFuture<Integer> ended = begin(input, "--once");
            String shown = shown();
            assertThat(page(shown)).isEqualTo(200);
            assertThat(pair(shown)).isInstanceOf(Paired.class);
            Await.until("the question", () -> err.toString().contains("boat-1234 shows the check code "));
            String code = PairingSecret.checkCode(
                    new KeyStoreFolder(folder.resolve("keys")).open().identity().fingerprint(), phone.fingerprint());
            assertThat(err.toString()).contains(code);
            assertThat(knowsThePhone()).isFalse();

            person.write("what?\ny\n".getBytes(StandardCharsets.UTF_8));
            person.flush();

            assertThat(ended.get(100, TimeUnit.SECONDS)).isZero();
            assertThat(err.toString()).contains("y or n?").contains("paired with boat-1234; say yes on the phone, too");
            assertThat(knowsThePhone()).isTrue();
            assertThatThrownBy(() -> page(shown)).isInstanceOf(ConnectException.class);
        }
    }

    @Test
    void withoutAPersonNoPhoneIsPaired() throws Exception {
        CompletableFuture<Integer> ended = begin(new ByteArrayInputStream(new byte[0]), "--once");
        pair(shown());

        assertThat(ended.get(100, TimeUnit.SECONDS)).isEqualTo(4);
        assertThat(err.toString()).contains("boat-1234 is not paired: nothing is kept here");
        assertThat(knowsThePhone()).isFalse();
    }

    @Test
    void fileThatIsNoAppIsRefusedBeforeAnythingIsServed() throws Exception {
        Path secret = Files.writeString(folder.resolve("secret.txt"), "secret");

        CompletableFuture<Integer> ended = begin(InputStream.nullInputStream(), "--apk", secret.toString());

        assertThat(ended.get(100, TimeUnit.SECONDS)).isEqualTo(2);
        assertThat(err.toString()).contains("secret.txt is no APK of the app").contains("./gradlew apk");
        assertThat(out.toString()).isEmpty();
    }
}

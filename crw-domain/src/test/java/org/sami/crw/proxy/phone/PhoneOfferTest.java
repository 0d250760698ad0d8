package org.sami.crw.proxy.phone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.OutputStream;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Pair;
import org.sami.boat.link.Paired;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.Identity;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;
import org.sami.crw.proxy.tcp.BoatAddress;

/** The app and the pairing, as a phone's browser and app get them over loopback. */
@Timeout(900)
class PhoneOfferTest {
    private static final byte[] CLASSES = "the classes of the app".getBytes(StandardCharsets.UTF_8);

    @TempDir
    private Path folder;

    private final KeyRing keys = KeyRing.inMemory();
    private final AtomicLong nowMs = new AtomicLong();
    private final BlockingQueue<PhoneOffer.Phone> proved = new LinkedBlockingQueue<>();
    private final BlockingQueue<String> refused = new LinkedBlockingQueue<>();
    private final HttpClient browser = HttpClient.newHttpClient();
    private final Identity phone = Identity.generate();
    private PhoneOffer offer;

    @BeforeEach
    void open() throws IOException {
        offer = open(Optional.of(ApkFile.read(apk("org.sami.boat.app"))));
    }

    @AfterEach
    void close() throws IOException {
        offer.close();
    }

    private PhoneOffer open(Optional<ApkFile> apk) throws IOException {
        return new PhoneOffer(
                new PhoneOffer.Setup(InetAddress.getLoopbackAddress(), apk, "ann at base", Role.COMMANDER),
                keys,
                nowMs::get,
                new PhoneOffer.Listener() {
                    @Override
                    public void proved(PhoneOffer.Phone one) {
                        proved.add(one);
                    }

                    @Override
                    public void refused(String why) {
                        refused.add(why);
                    }
                });
    }

    private Path apk(String javaPackage) throws IOException {
        Path file = folder.resolve("app.apk");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
            zip.putNextEntry(new ZipEntry("AndroidManifest.xml"));
            zip.write(javaPackage.getBytes(StandardCharsets.UTF_16LE));
            zip.putNextEntry(new ZipEntry("classes.dex"));
            zip.write(CLASSES);
        }
        return file;
    }

    private String page() {
        return offer.code().split("#", 2)[0];
    }

    private PairingCode code() {
        return PairingCode.parse(offer.code().split("#", 2)[1]);
    }

    private HttpResponse<byte[]> get(String url) throws Exception {
        return send(HttpRequest.newBuilder(URI.create(url)).build());
    }

    private HttpResponse<byte[]> send(HttpRequest request) throws Exception {
        return browser.send(request, BodyHandlers.ofByteArray());
    }

    private LinkMessage say(LinkMessage message, PairingCode code) throws Exception {
        BoatAddress at = BoatAddress.parse(code.address());
        try (Socket socket = new Socket(at.host(), at.port())) {
            SecureLink link = TlsLinks.toPair(phone).connect(socket);
            assertThat(link.peer()).as("the key that the code names").contains(code.key());
            link.out().write(LinkCodec.STANDARD.encode(0, message));
            return LinkCodec.STANDARD
                    .decode(new FrameReader(link.in(), LinkCodec.STANDARD)
                            .next()
                            .orElseThrow())
                    .message();
        }
    }

    private LinkMessage pair(PairingCode code, PairingSecret words) throws Exception {
        return say(new Pair("boat-1234", words.proofOfBoat(code.key(), phone.fingerprint())), code);
    }

    @Test
    void phoneGetsTheAppAndIsPairedOnceAPersonHasComparedTheCheckCode() throws Exception {
        HttpResponse<byte[]> app = get(page() + "sami-boat.apk");
        assertThat(app.statusCode()).isEqualTo(200);
        assertThat(app.body()).isEqualTo(Files.readAllBytes(folder.resolve("app.apk")));
        assertThat(app.headers().firstValue("Content-Type")).contains("application/vnd.android.package-archive");

        PairingCode code = code();
        LinkMessage answer = pair(code, code.words());

        assertThat(answer).isInstanceOf(Paired.class);
        assertThat(((Paired) answer).proof()).isEqualTo(code.words().proofOfBase(code.key(), phone.fingerprint()));
        PhoneOffer.Phone one = proved.poll(60, TimeUnit.SECONDS);
        assertThat(one.checkCode()).isEqualTo(PairingSecret.checkCode(code.key(), phone.fingerprint()));
        assertThat(keys.peers())
                .as("nothing is kept before the person has answered")
                .isEmpty();

        offer.confirm();

        assertThat(keys.find(phone.fingerprint()))
                .get()
                .satisfies(peer -> assertThat(peer.name()).isEqualTo("boat-1234"));
        assertThat(code().words()).as("the next phone gets other words").isNotEqualTo(code.words());
    }

    @Test
    void otherCheckCodeKeepsNothing() throws Exception {
        pair(code(), code().words());
        proved.poll(60, TimeUnit.SECONDS);

        offer.deny();

        assertThat(keys.peers()).isEmpty();
        assertThat(offer.waiting()).isEmpty();
    }

    @Test
    void pageHandsTheCodeToTheAppAndDoesNotContainIt() throws Exception {
        HttpResponse<byte[]> page = get(page());
        String text = new String(page.body(), StandardCharsets.UTF_8);

        assertThat(text)
                .contains("href=\"sami-boat.apk\"", "intent://pair/", "package=org.sami.boat.app")
                .doesNotContain(code().words().shortText(), code().key().toString());
        assertThat(page.headers().firstValue("Cache-Control")).contains("no-store");
    }

    @ParameterizedTest
    @ValueSource(strings = {"../app.apk", "app.apk", "sami-boat.apk/", "%2e%2e/app.apk", "..%2f..%2fetc/passwd", "x"})
    void nothingElseIsServed(String name) throws Exception {
        assertThat(get(page() + name).statusCode()).isEqualTo(404);
    }

    @Test
    void withoutThePathOfTheCodeNothingIsServed() throws Exception {
        URI at = URI.create(page());
        String root = at.getScheme() + "://" + at.getAuthority() + "/";

        assertThat(get(root).statusCode()).isEqualTo(404);
        assertThat(get(root + "sami-boat.apk").statusCode()).isEqualTo(404);
        assertThat(send(HttpRequest.newBuilder(URI.create(page() + "sami-boat.apk"))
                                .PUT(HttpRequest.BodyPublishers.ofString("another app"))
                                .build())
                        .statusCode())
                .isEqualTo(405);
    }

    @Test
    void whatHasTakenThePlaceOfTheAppIsNotServed() throws Exception {
        Files.writeString(folder.resolve("app.apk"), "a secret");

        assertThatThrownBy(() -> get(page() + "sami-boat.apk")).isInstanceOf(IOException.class);
    }

    @Test
    void nothingIsServedOnceTheCodeIsShownNoLonger() throws Exception {
        String page = page();
        PairingCode code = code();
        offer.close();

        assertThatThrownBy(() -> get(page)).isInstanceOf(ConnectException.class);
        assertThatThrownBy(() -> pair(code, code.words())).isInstanceOf(ConnectException.class);
    }

    @Test
    void fiveWrongProofsChangeTheWords() throws Exception {
        PairingCode shown = code();
        for (int i = 0; i < 5; i++) {
            assertThat(pair(shown, PairingSecret.random())).isInstanceOf(Goodbye.class);
        }

        assertThat(code().words()).isNotEqualTo(shown.words());
        LinkMessage late = pair(shown, shown.words());
        assertThat(((Goodbye) late).reason()).contains("the words are not those of the code");
        assertThat(keys.peers()).isEmpty();
    }

    @Test
    void wordsCountNoLongerThanTheirTime() throws Exception {
        PairingCode shown = code();
        nowMs.addAndGet(PhoneResponder.WORDS_MS);

        assertThat(((Goodbye) pair(shown, shown.words())).reason()).contains("the code counts no longer");
        assertThat(code().words()).isNotEqualTo(shown.words());
    }

    @Test
    void whoAsksForAnythingElseIsRefusedAndDoesNotDisturbOthers() throws Exception {
        PairingCode code = code();
        assertThat(say(new Hello("boat", "base", Role.COMMANDER, 10, ""), code)).isInstanceOf(Goodbye.class);
        BoatAddress at = BoatAddress.parse(code.address());
        try (Socket noise = new Socket(at.host(), at.port())) {
            OutputStream out = noise.getOutputStream();
            out.write(new byte[1000]);
            out.flush();
            assertThat(refused.poll(60, TimeUnit.SECONDS)).isNotEmpty();
        }

        assertThat(pair(code, code.words())).isInstanceOf(Paired.class);
    }

    @Test
    void withoutTheAppThePageSaysSoAndPairsAllTheSame() throws Exception {
        offer.close();
        offer = open(Optional.empty());

        assertThat(new String(get(page()).body(), StandardCharsets.UTF_8)).contains("no copy of the app");
        assertThat(get(page() + "sami-boat.apk").statusCode()).isEqualTo(404);
        assertThat(pair(code(), code().words())).isInstanceOf(Paired.class);
    }

    @Test
    void onlyAnApkOfTheAppIsTaken() throws Exception {
        Path text = Files.writeString(folder.resolve("notes.txt"), "org.sami.boat.app");

        assertThatThrownBy(() -> ApkFile.read(text)).hasMessageContaining("notes.txt is no APK of the app");
        assertThatThrownBy(() -> ApkFile.read(apk("com.example.other"))).hasMessageContaining("no APK of the app");
        assertThatThrownBy(() -> ApkFile.read(folder.resolve("none.apk")))
                .hasMessageContaining("there is no file")
                .hasMessageContaining("./gradlew apk");
    }

    @Test
    void builtAppIsFoundFromAFolderOfTheProject() throws Exception {
        Path built = folder.resolve("boat-server-android/app/build/sami-boat.apk");
        Files.createDirectories(built.getParent());
        Files.copy(apk("org.sami.boat.app"), built);

        assertThat(ApkFile.find(folder.resolve("crw-cli/build/install/crw"), Optional.empty()))
                .contains(built);
        assertThat(ApkFile.find(folder.resolve("crw-cli"), Optional.empty())).contains(built);
    }
}

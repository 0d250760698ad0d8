package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.crw.proxy.file.BoatFileFetch;
import org.sami.crw.proxy.file.FileFetchException;
import org.sami.crw.proxy.file.FileNews;
import org.sami.spn.value.GeoPoint;

/** Files of a boat on a real port come whole to a folder of the base, however often the link is cut. */
@Timeout(900)
class BoatFileFetchTest {
    @TempDir
    private Path folder;

    private BoatOnTcp boat(TestLinks links) throws IOException {
        InetSocketAddress anyPort = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        BoatSettings settings =
                BoatSettings.of("anna", anyPort, new GeoPoint(45.4, 10.9, 0), 1).loggingTo(folder.resolve("boat"));
        return new BoatOnTcp(
                settings,
                SteadyClock.ofThisMachine(),
                new TcpServerListener() {},
                plain ->
                        links.ofBoat("anna").apply(plain.withFiles(plain.files().with(KeptFile.PICTURE, pictures()))));
    }

    private Path pictures() {
        return folder.resolve("pictures");
    }

    private Path picture(String name, int bytes) throws IOException {
        Files.createDirectories(pictures());
        byte[] content = new byte[bytes];
        new SplittableRandom(bytes).nextBytes(content);
        return Files.write(pictures().resolve(name), content);
    }

    static Stream<TestLinks> links() {
        return Stream.of(TestLinks.plain(), TestLinks.withKeys());
    }

    @ParameterizedTest
    @MethodSource("links")
    void cutLinksAreMadeAnewAndTheFileIsWhole(TestLinks links) throws Exception {
        Path picture = picture("a.jpg", 300_001);
        SplittableRandom random = new SplittableRandom(7);
        try (BoatOnTcp boat = boat(links);
                CuttingRelay relay = new CuttingRelay(
                        boat.address(), number -> number < 12 ? 30_000 + random.nextInt(20_000) : Integer.MAX_VALUE)) {
            BoatFileFetch fetch = new BoatFileFetch(relay.address(), links.ofBaseItself(), FileNews.NONE);
            Path got = fetch.fetch("anna", KeptFile.PICTURE, "a.jpg", folder.resolve("base"));

            assertThat(got).hasSameBinaryContentAs(picture);
            assertThat(relay.connections()).as("links").isGreaterThan(5);
            assertThat(folder.resolve("base/a.jpg.part")).doesNotExist();
        }
    }

    @Test
    void fetchGoesOnFromAnyByteAndFetchesNoByteTwice() throws Exception {
        byte[] content = Files.readAllBytes(picture("a.jpg", 20_000));
        try (BoatOnTcp boat = boat(TestLinks.plain())) {
            for (int here : new int[] {0, 1, 5_999, 6_000, 6_001, 19_999, 20_000}) {
                Path base = folder.resolve("base" + here);
                Files.createDirectories(base.resolve("anna"));
                Files.write(base.resolve("anna/a.jpg.part"), Arrays.copyOf(content, here));

                BoatFileFetch.Result result = all(boat, KeptFile.PICTURE, base);
                assertThat(result.bytes()).isEqualTo(20_000 - here);
                assertThat(base.resolve("anna/a.jpg")).hasBinaryContent(content);
            }
        }
    }

    @Test
    void partOfAnotherFileIsFetchedAnew() throws Exception {
        byte[] content = Files.readAllBytes(picture("a.jpg", 20_000));
        try (BoatOnTcp boat = boat(TestLinks.plain())) {
            Path base = folder.resolve("base");
            Files.createDirectories(base.resolve("anna"));
            Files.write(base.resolve("anna/a.jpg.part"), new byte[7_000]);

            all(boat, KeptFile.PICTURE, base);
            assertThat(base.resolve("anna/a.jpg")).hasBinaryContent(content);
        }
    }

    @Test
    void secondFetchOfALogFetchesOnlyWhatIsNew() throws Exception {
        try (BoatOnTcp boat = boat(TestLinks.plain())) {
            Path base = folder.resolve("base");
            Path log = folder.resolve("boat/anna.log");
            assertThat(all(boat, KeptFile.LOG, base).bytes()).isEqualTo(Files.size(log));
            assertThat(all(boat, KeptFile.LOG, base).bytes()).isZero();

            Files.writeString(log, "0123456789", StandardOpenOption.APPEND);
            assertThat(all(boat, KeptFile.LOG, base).bytes()).isEqualTo(10);
            assertThat(base.resolve("anna/anna.log")).hasSameBinaryContentAs(log);
        }
    }

    @Test
    void copyOfALogThatTheBoatKeepsNoLongerStays() throws Exception {
        try (BoatOnTcp boat = boat(TestLinks.plain())) {
            Path base = folder.resolve("base");
            Files.createDirectories(base.resolve("anna"));
            Files.writeString(base.resolve("anna/anna.log"), "of another boat of that name");

            all(boat, KeptFile.LOG, base);
            assertThat(base.resolve("anna/anna.log.1")).hasContent("of another boat of that name");
            assertThat(base.resolve("anna/anna.log")).hasSameBinaryContentAs(folder.resolve("boat/anna.log"));
        }
    }

    @Test
    void whatTheBoatRefusesIsNamedAndTheOthersCome() throws Exception {
        picture("b.jpg", 100);
        try (var large =
                new java.io.RandomAccessFile(pictures().resolve("a.jpg").toFile(), "rw")) {
            large.setLength(200_000_000);
        }
        try (BoatOnTcp boat = boat(TestLinks.plain())) {
            BoatFileFetch.Result result = all(boat, KeptFile.PICTURE, folder.resolve("base"));

            assertThat(result.files()).containsExactly(folder.resolve("base/anna/b.jpg"));
            assertThat(result.refused()).singleElement().asString().contains("a.jpg", "200000000");
        }
    }

    @Test
    void anotherBoatOrAnUnknownNameIsToldInWords() throws Exception {
        picture("a.jpg", 1);
        try (BoatOnTcp boat = boat(TestLinks.plain())) {
            BoatFileFetch fetch = new BoatFileFetch(boat.address(), new OpenLinks(), FileNews.NONE);

            assertThatThrownBy(() -> fetch.fetch("bert", KeptFile.PICTURE, "a.jpg", folder))
                    .isInstanceOf(FileFetchException.class)
                    .hasMessageContaining("answers anna, not bert");
            assertThatThrownBy(() -> fetch.fetch("anna", KeptFile.PICTURE, "z.jpg", folder))
                    .hasMessage("anna keeps no picture z.jpg, or does so no longer");
        }
    }

    @Test
    void cancelledFetchKeepsWhatHasCome() throws Exception {
        picture("a.jpg", 300_000);
        try (BoatOnTcp boat = boat(TestLinks.plain())) {
            BoatFileFetch[] fetch = new BoatFileFetch[1];
            fetch[0] = new BoatFileFetch(boat.address(), new OpenLinks(), (boatId, name, here, bytes) -> {
                if (here >= 60_000) {
                    fetch[0].cancel();
                }
            });

            assertThatThrownBy(() -> fetch[0].fetchAll(KeptFile.PICTURE, folder.resolve("base")))
                    .hasMessage("cancelled; what has come is kept");
            assertThat(folder.resolve("base/anna/a.jpg.part")).hasSize(60_000);
        }
    }

    @Test
    void boatOfBeforeIsToldInOneLine() throws Exception {
        try (BoatOfBefore boat = new BoatOfBefore()) {
            BoatFileFetch fetch = new BoatFileFetch(boat.address(), new OpenLinks(), FileNews.NONE);

            assertThatThrownBy(() -> fetch.fetchAll(KeptFile.LOG, folder))
                    .hasMessage("anna: its server gives no files yet; bring it to this version");
        }
    }

    private static BoatFileFetch.Result all(BoatOnTcp boat, String kind, Path base) throws IOException {
        return new BoatFileFetch(boat.address(), new OpenLinks(), FileNews.NONE).fetchAll(kind, base);
    }
}

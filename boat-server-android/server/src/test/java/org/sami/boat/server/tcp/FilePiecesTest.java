package org.sami.boat.server.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.FileAnswer;
import org.sami.boat.link.FileList;
import org.sami.boat.link.FilePiece;
import org.sami.boat.link.FileRefusal;
import org.sami.boat.link.FileRefusal.Reason;
import org.sami.boat.link.GetPiece;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.ListFiles;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Role;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.file.BoatFiles;
import org.sami.boat.server.tcp.TcpBench.Client;

/** A boat gives its files in pieces, and nothing else of its disk. */
@Timeout(900)
class FilePiecesTest {
    @TempDir
    private Path folder;

    /** A boat with links of the kind that is tested. */
    TcpBench bench(UnaryOperator<ServerConfig.Builder> boat, UnaryOperator<TcpServerConfig> tcp) throws IOException {
        return new TcpBench(boat, tcp);
    }

    private TcpBench bench() throws Exception {
        Files.createDirectories(folder.resolve("kept"));
        Files.writeString(folder.resolve("secret"), "secret");
        return bench(
                UnaryOperator.identity(),
                tcp -> tcp.withFiles(BoatFiles.none().with(KeptFile.PICTURE, folder.resolve("kept"))));
    }

    private byte[] keep(String name, int bytes) throws Exception {
        byte[] content = new byte[bytes];
        SplittableRandom random = new SplittableRandom(bytes);
        random.nextBytes(content);
        Files.createDirectories(folder.resolve("kept"));
        Files.write(folder.resolve("kept").resolve(name), content);
        return content;
    }

    private static FileRefusal refused(Client client, String name, long offset) throws Exception {
        client.say(new GetPiece("r", name, offset, 10));
        return client.await(FileRefusal.class);
    }

    @Test
    void observerListsAndFetchesWholeFile() throws Exception {
        byte[] content = keep("a.jpg", 10_000);
        try (TcpBench bench = bench()) {
            Client client = bench.greet("observer", Role.OBSERVER, 1);
            client.say(new ListFiles("r1", KeptFile.PICTURE, ""));
            KeptFile listed = client.await(FileList.class).files().get(0);
            assertThat(listed.name()).isEqualTo("a.jpg");
            assertThat(listed.bytes()).isEqualTo(10_000);
            assertThat(listed.sha256())
                    .isEqualTo(HexFormat.of()
                            .formatHex(MessageDigest.getInstance("SHA-256").digest(content)));

            client.say(new GetPiece("r2", "a.jpg", 7_000, FilePiece.MAX_BYTES));
            byte[] end = client.await(FilePiece.class).content();
            assertThat(end).isEqualTo(java.util.Arrays.copyOfRange(content, 7_000, 10_000));
            client.say(new GetPiece("r3", "a.jpg", 10_000, 1));
            assertThat(client.await(FilePiece.class).content()).isEmpty();
        }
    }

    @Test
    void listComesInPagesInTheOrderOfNames() throws Exception {
        for (int i = 0; i < 65; i++) {
            keep("%03d.jpg".formatted(i), 1);
        }
        try (TcpBench bench = bench()) {
            Client client = bench.greet("observer", Role.OBSERVER, 1);
            client.say(new ListFiles("r1", "", "029.jpg"));
            FileList page = client.await(FileList.class);

            assertThat(page.files().stream().map(KeptFile::name))
                    .containsExactlyElementsOf(IntStream.range(30, 60)
                            .mapToObj("%03d.jpg"::formatted)
                            .toList());
            assertThat(page.more()).isTrue();
            client.say(new ListFiles("r2", KeptFile.LOG, ""));
            assertThat(client.await(FileList.class).files()).isEmpty();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"../secret", "..", ".", "b.jpg", "/etc/passwd", "kept/../../secret", "link.jpg", "c.part"})
    void noOtherFileIsOpened(String name) throws Exception {
        keep("a.jpg", 10);
        keep("c.part", 10);
        try (TcpBench bench = bench()) {
            Files.createSymbolicLink(folder.resolve("kept/link.jpg"), folder.resolve("secret"));
            Client client = bench.greet("observer", Role.OBSERVER, 1);

            assertThat(refused(client, name, 0).reason()).isEqualTo(Reason.UNKNOWN_FILE);
        }
    }

    @Test
    void fileThatIsGoneOrShorterIsRefusedWithItsLength() throws Exception {
        keep("a.jpg", 10);
        try (TcpBench bench = bench()) {
            Client client = bench.greet("observer", Role.OBSERVER, 1);
            FileRefusal past = refused(client, "a.jpg", 11);
            assertThat(past.reason()).isEqualTo(Reason.PAST_END);
            assertThat(past.detail()).contains("10 bytes");

            Files.delete(folder.resolve("kept/a.jpg"));
            assertThat(refused(client, "a.jpg", 0).reason()).isEqualTo(Reason.UNKNOWN_FILE);
        }
    }

    @Test
    void pictureOf200MegabytesIsListedAndRefusedWithItsSize() throws Exception {
        try (TcpBench bench = bench()) {
            try (RandomAccessFile large =
                    new RandomAccessFile(folder.resolve("kept/large.jpg").toFile(), "rw")) {
                large.setLength(200_000_000);
            }
            Client client = bench.greet("observer", Role.OBSERVER, 1);
            client.say(new ListFiles("r1", "", ""));
            assertThat(client.await(FileList.class).files().get(0).isTooLarge()).isTrue();
            FileRefusal refusal = refused(client, "large.jpg", 0);

            assertThat(refusal.reason()).isEqualTo(Reason.TOO_LARGE);
            assertThat(refusal.detail()).contains("200000000");
        }
    }

    @Test
    void whoHasNotSaidHelloGetsNothing() throws Exception {
        keep("a.jpg", 10);
        try (TcpBench bench = bench()) {
            Client client = bench.connect();
            client.say(new GetPiece("r", "a.jpg", 0, 10));

            assertThat(client.await(Nack.class).reason()).isEqualTo(NackReason.NOT_GREETED);
        }
    }

    @Test
    void boatWithoutFilesListsNone() throws Exception {
        try (TcpBench bench = bench(UnaryOperator.identity(), UnaryOperator.identity())) {
            Client client = bench.greet("observer", Role.OBSERVER, 1);
            client.say(new ListFiles("r", "", ""));

            assertThat(client.await(FileList.class).files()).isEmpty();
        }
    }

    @Test
    void whoAsksForManyPiecesAtOnceGetsOneAndCommandsAreAnsweredBetween() throws Exception {
        keep("a.jpg", 100_000);
        try (TcpBench bench = bench()) {
            Client client = bench.greet("base", Role.COMMANDER, 10);
            int asked = 50;
            for (int i = 0; i < asked; i++) {
                client.say(new GetPiece("r" + i, "a.jpg", 0, FilePiece.MAX_BYTES));
            }
            client.say(new HoldPosition("c"));
            int pieces = 0;
            int busy = 0;
            while (pieces + busy < asked) {
                FileAnswer answer = client.await(FileAnswer.class);
                pieces += answer instanceof FilePiece ? 1 : 0;
                busy += answer instanceof FileRefusal refusal && refusal.reason() == Reason.BUSY ? 1 : 0;
            }

            assertThat(pieces).isPositive();
            assertThat(busy).isPositive();
            assertThat(bench.executed).containsExactly("c ack");
        }
    }

    @Test
    void acknowledgementWaitsForOnePieceAtMost() throws Exception {
        keep("a.jpg", 600_000);
        try (TcpBench bench = bench()) {
            Client client = bench.greet("base", Role.COMMANDER, 10);
            for (int i = 0; i < 50; i++) {
                client.say(new GetPiece("r" + i, "a.jpg", 6000L * i, FilePiece.MAX_BYTES));
                client.say(new HoldPosition("c" + i));
                int piecesBefore = 0;
                boolean acknowledged = false;
                boolean come = false;
                while (!acknowledged || !come) {
                    var message = client.await(org.sami.boat.link.LinkMessage.class);
                    acknowledged |= message instanceof Ack;
                    come |= message instanceof FilePiece;
                    piecesBefore += message instanceof FilePiece && !acknowledged ? 1 : 0;
                }
                assertThat(piecesBefore).isLessThanOrEqualTo(1);
            }
            assertThat(bench.failures).isEmpty();
        }
    }
}

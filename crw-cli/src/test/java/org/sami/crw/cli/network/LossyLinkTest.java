package org.sami.crw.cli.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CrwProcess;
import org.sami.session.client.testing.TwoNetworks;

/** A console of a session elsewhere over a network that loses one packet in five each way: real processes, in networks of their own. */
@Tag("process")
@Timeout(2400)
class LossyLinkTest {
    private static final double LOST = 0.2;
    private static final double AT_MOST_S = 300;
    private static final int RUNS = 3;

    @TempDir
    private Path folder;

    @Test
    void missionIsStartedAnsweredAndSeenToItsEnd() throws Exception {
        Path people = folder.resolve("people");
        Path key = Files.writeString(folder.resolve("anna.key"), key(people));
        Path boats = Files.writeString(folder.resolve("boats"), "add boat 45.4,10.9 1\n");
        Path script = Files.write(
                folder.resolve("script"),
                List.of(
                        "abort all",
                        "wait boats 1 within 60",
                        "start clv",
                        "wait decision within 60",
                        "answer all",
                        "wait decision within 60",
                        "answer 45.40003,10.90003",
                        "wait decision within 60",
                        "answer 1",
                        "wait ended within 60",
                        "quit"));
        try (TwoNetworks networks = new TwoNetworks()) {
            networks.lose(LOST);
            try (CrwProcess base = CrwProcess.startBy(
                    networks.inFirst(),
                    folder,
                    List.of(
                            "serve",
                            "--host",
                            TwoNetworks.FIRST_ADDRESS,
                            "--port",
                            "0",
                            "--people",
                            people.toString(),
                            "--keys",
                            folder.resolve("keys").toString(),
                            "--script",
                            boats.toString()))) {
                Matcher served = served(base);

                List<String> elsewhere = new ArrayList<>(networks.inSecond());
                elsewhere.addAll(List.of("env", "JAVA_OPTS=-Duser.home=" + folder.resolve("home")));
                List<String> line = List.of(
                        "session",
                        "--session",
                        "wss://" + served.group(1),
                        "--person",
                        "anna",
                        "--key-file",
                        key.toString(),
                        "--certificate",
                        served.group(2),
                        "--script",
                        script.toString());

                assertThat(carriedOut(elsewhere, line)).containsPattern("mission \\d+ of clv: ended at ");
            }
        }
    }

    /** What a console said that carried out all its lines. One whose command met the loss of its connection says so, and is run again, as its user would do. */
    private String carriedOut(List<String> elsewhere, List<String> line) throws Exception {
        for (int run = 1; run < RUNS; run++) {
            try (CrwProcess console = CrwProcess.startBy(elsewhere, folder, line)) {
                if (console.await(600) == 0) {
                    return console.out();
                }
                assertThat(console.out() + console.err())
                        .containsAnyOf("connection lost", "nothing comes", "timed out");
            }
        }
        try (CrwProcess console = CrwProcess.startBy(elsewhere, folder, line)) {
            assertThat(console.await(600)).as(console.out() + console.err()).isZero();
            return console.out();
        }
    }

    /** Lists anna, and gives her key. */
    private String key(Path people) throws Exception {
        try (CrwProcess added = CrwProcess.start(
                folder, List.of("people", "add", "anna", "--role", "operator", "--people", people.toString()))) {
            assertThat(added.await(120)).as(added.err()).isZero();
            return added.out().lines().toList().get(1);
        }
    }

    /** Where a base serves its session, and its certificate. */
    private static Matcher served(CrwProcess base) {
        Pattern pattern = Pattern.compile("the session is at https://(\\S+)/\\R.*SHA-256 (\\S+)");
        Await.until(
                "the session is served",
                AT_MOST_S,
                () -> pattern.matcher(base.out()).find() || !base.isAlive());
        Matcher served = pattern.matcher(base.out());
        assertThat(served.find()).as(base.out() + base.err()).isTrue();
        return served;
    }
}

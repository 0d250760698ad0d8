package org.sami.architecture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** tools/second-attempt.sh, which {@code .ci/run} calls, in a folder whose gradlew notes its arguments and makes a summary. */
class SecondAttemptTest {
    private static final Path SCRIPT = Path.of("tools", "second-attempt.sh").toAbsolutePath();
    private static final String LINK = "FAILED org.sami.LinkTest cut(): not within 120 s";
    private static final String RUN = "FAILED org.sami.RunTest killed(): timed out";

    @TempDir
    private Path folder;

    @BeforeEach
    void failInTwoTasks() throws IOException {
        result("crw-sim/build/test-results/test", "org.sami.LinkTest");
        result("crw-cli/build/test-results/processTest", "org.sami.RunTest");
        result("spn-core/build/test-results/test", "org.sami.EngineTest");
        Files.createDirectories(folder.resolve("build"));
        gradle("2 passed, 0 failed", 0);
    }

    private void result(String tasks, String test) throws IOException {
        Path results = Files.createDirectories(folder.resolve(tasks));
        Files.writeString(results.resolve("TEST-" + test + ".xml"), "<testsuite/>");
    }

    private void gradle(String says, int code) throws IOException {
        Path gradle = folder.resolve("gradlew");
        Files.writeString(gradle, """
            #!/bin/bash
            echo "$@" > called
            echo '%s' > build/test-summary.txt
            exit %d
            """.formatted(says, code));
        assertThat(gradle.toFile().setExecutable(true)).isTrue();
    }

    private void failed(String... lines) throws IOException {
        Files.writeString(summary(), String.join("\n", lines) + "\n");
    }

    private Path summary() {
        return folder.resolve("build/test-summary.txt");
    }

    private int attempt() throws IOException, InterruptedException {
        Process process = new ProcessBuilder("bash", SCRIPT.toString(), folder.toString())
                .redirectErrorStream(true)
                .start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(said).doesNotContain("second-attempt.sh: line");
        return process.waitFor();
    }

    @Test
    void testsThatPassByThemselvesAreCountedAndNamed() throws Exception {
        failed(LINK, RUN, "3 skipped, for what they read is not on this machine", "98 passed, 2 failed");

        assertThat(attempt()).isZero();

        assertThat(summary()).hasContent("""
            passed at the second attempt, by itself: org.sami.LinkTest cut(): not within 120 s
            passed at the second attempt, by itself: org.sami.RunTest killed(): timed out
            3 skipped, for what they read is not on this machine
            100 passed, 0 failed
            """);
        assertThat(folder.resolve("called"))
                .content()
                .endsWith(" :crw-sim:test --tests org.sami.LinkTest :crw-cli:processTest --tests org.sami.RunTest\n");
    }

    @Test
    void testThatFailsTwiceHasFailed() throws Exception {
        gradle(LINK + "\n0 passed, 1 failed", 1);
        failed(LINK, "99 passed, 1 failed");

        assertThat(attempt()).isEqualTo(1);

        assertThat(summary()).hasContent(LINK + "\n99 passed, 1 failed\n");
    }

    @Test
    void buildThatFailsOtherwiseHasFailed() throws Exception {
        gradle("1 passed, 0 failed", 1);
        failed(LINK, "99 passed, 1 failed");

        assertThat(attempt()).isEqualTo(1);

        assertThat(summary()).hasContent(LINK + "\n99 passed, 1 failed\n");
    }

    @Test
    void testWithoutRealTimeGetsNoSecondAttempt() throws Exception {
        failed(LINK, "FAILED org.sami.EngineTest fires(): 1 is not 2", "98 passed, 2 failed");

        assertThat(attempt()).isEqualTo(1);

        assertThat(folder.resolve("called")).doesNotExist();
    }

    @Test
    void manyFailuresGetNoSecondAttempt() throws Exception {
        List<String> lines = new ArrayList<>(Collections.nCopies(11, LINK));
        lines.add("89 passed, 11 failed");
        failed(lines.toArray(String[]::new));

        assertThat(attempt()).isEqualTo(1);

        assertThat(folder.resolve("called")).doesNotExist();
    }

    @Test
    void buildThatFailedWithoutFailedTestsGetsNoSecondAttempt() throws Exception {
        failed("100 passed, 0 failed");

        assertThat(attempt()).isEqualTo(1);

        assertThat(folder.resolve("called")).doesNotExist();
    }

    @Test
    void wholeCheckOfACloneMakesTheSecondAttempt() throws IOException {
        assertThat(Files.readString(Path.of(".ci", "run"))).contains("tools/second-attempt.sh");
    }
}

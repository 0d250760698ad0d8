package org.sami.architecture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** tools/commit-subjects.sh, which {@code .ci/run} calls, on small repositories of its own. */
class CommitSubjectsTest {
    private static final String SCRIPT =
            Path.of("tools", "commit-subjects.sh").toAbsolutePath().toString();
    private static final String LATER = "2027-01-01T12:00:00Z";
    private static final String EARLIER = "2026-11-25T12:00:00Z";

    @TempDir
    private Path folder;

    /** What a process said, and its exit code. */
    private record Outcome(int code, String said) {}

    @BeforeEach
    void needsGit() throws Exception {
        boolean isThere = Stream.of(System.getenv("PATH").split(File.pathSeparator))
                .anyMatch(path -> Files.isExecutable(Path.of(path, "git")));
        assumeTrue(isThere, "git is not installed");
        run(folder, LATER, "git", "init", "-q");
    }

    private static Outcome run(Path folder, String written, String... command)
            throws IOException, InterruptedException {
        ProcessBuilder builder =
                new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
        builder.environment().put("GIT_CEILING_DIRECTORIES", folder.getParent().toString());
        builder.environment().put("GIT_AUTHOR_DATE", written);
        for (String who : List.of("AUTHOR", "COMMITTER")) {
            builder.environment().put("GIT_" + who + "_NAME", "anna");
            builder.environment().put("GIT_" + who + "_EMAIL", "anna@example.org");
        }
        Process process = builder.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Outcome(process.waitFor(), said);
    }

    private void commit(String written, String subject) throws Exception {
        Outcome made =
                run(folder, written, "git", "commit", "-q", "--allow-empty", "-m", subject + "\n\n" + "b".repeat(90));
        assertThat(made.code()).as(made.said()).isZero();
    }

    private static Outcome check(Path folder) throws Exception {
        return run(folder, LATER, "bash", SCRIPT, folder.toString());
    }

    @Test
    void subjectOf73CharactersIsNamed() throws Exception {
        commit(LATER, "é".repeat(72));
        assertThat(check(folder)).isEqualTo(new Outcome(0, ""));

        commit(LATER, "x".repeat(73));
        commit(LATER, "Hold a boat that lost its link");

        assertThat(check(folder).code()).isEqualTo(1);
        assertThat(check(folder).said()).contains("73 characters").contains("x".repeat(73));
    }

    @Test
    void commitsFromBeforeTheCheckAreLeftAlone() throws Exception {
        commit(EARLIER, "x".repeat(100));

        assertThat(check(folder).code()).isZero();
    }

    @Test
    void absentOrShallowHistoryPasses(@TempDir Path other) throws Exception {
        Path none = Files.createDirectory(other.resolve("none"));
        assertThat(check(none).code()).isZero();

        commit(LATER, "x".repeat(73));
        commit(LATER, "Hold a boat that lost its link");
        Path shallow = other.resolve("shallow");
        assertThat(run(other, LATER, "git", "clone", "-q", "--depth", "1", "file://" + folder, shallow.toString())
                        .code())
                .isZero();

        assertThat(check(shallow)).isEqualTo(new Outcome(0, ""));
    }

    @Test
    void wholeCheckOfACloneLooksAtSubjects() throws IOException {
        assertThat(Files.readString(Path.of(".ci", "run"))).contains("tools/commit-subjects.sh");
    }
}

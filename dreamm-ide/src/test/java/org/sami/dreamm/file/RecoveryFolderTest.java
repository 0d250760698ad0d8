package org.sami.dreamm.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.testing.JavaProcess;

class RecoveryFolderTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Project CLV = DOMAIN.projectOf("clv").orElseThrow();

    @TempDir
    private Path folder;

    @Test
    void whatAKilledProcessHadNotSavedIsLeftBehindWhole() throws Exception {
        Path path = folder.resolve("clv.json");
        Path shared = folder.resolve("unsaved");
        new ProjectWriter(DOMAIN.vocabulary()).write(CLV, path);
        Process process = JavaProcess.builder(folder, UnsavedProcess.class, shared.toString(), path.toString())
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("process.log").toFile())
                .start();
        try {
            long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
            while (!Files.exists(shared.resolve("1/unsaved.json")) && process.isAlive() && System.nanoTime() < end) {
                LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(20));
            }
            assertThat(RecoveryFolder.leftBehind(shared)).as("while it lives").isEmpty();
        } finally {
            process.destroyForcibly().waitFor();
        }

        List<UnsavedWork> left = RecoveryFolder.leftBehind(shared);

        assertThat(left).as(Files.readString(folder.resolve("process.log"))).hasSize(1);
        assertThat(left.get(0).file()).contains(path);
        assertThat(new ProjectReader(DOMAIN.vocabulary())
                        .read(left.get(0).project())
                        .orThrow())
                .isEqualTo(CLV.withName("not saved"));
    }

    @Test
    void aSecondProcessTakesAFolderOfItsOwnAndLeavesWhatWasLeftBehind() throws IOException {
        try (RecoveryFolder first = RecoveryFolder.take(folder, DOMAIN.vocabulary());
                RecoveryFolder second = RecoveryFolder.take(folder, DOMAIN.vocabulary())) {
            first.keep(CLV, Optional.empty());
            second.keep(CLV.withName("second"), Optional.empty());
        }

        try (RecoveryFolder third = RecoveryFolder.take(folder, DOMAIN.vocabulary())) {
            third.keep(CLV.withName("third"), Optional.empty());
            assertThat(RecoveryFolder.leftBehind(folder))
                    .extracting(work -> work.folder().getFileName().toString())
                    .containsExactlyInAnyOrder("1", "2");
        }
    }

    @Test
    void whatIsForgottenIsOfferedNoMore() throws IOException {
        try (RecoveryFolder kept = RecoveryFolder.take(folder, DOMAIN.vocabulary())) {
            kept.keep(CLV, Optional.of(folder.resolve("clv.json")));
        }

        RecoveryFolder.forget(RecoveryFolder.leftBehind(folder).get(0));

        assertThat(RecoveryFolder.leftBehind(folder)).isEmpty();
    }
}

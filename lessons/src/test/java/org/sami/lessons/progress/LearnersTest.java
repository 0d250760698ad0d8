package org.sami.lessons.progress;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.lessons.course.Course.StepAddress;

class LearnersTest {
    private static final StepAddress PLACES = new StepAddress("02-places", "places");

    @TempDir
    Path folder;

    private Learners learners;

    @BeforeEach
    void open() {
        learners = new Learners(folder.resolve("learners"));
    }

    @Test
    void whatWasKeptIsThereAgain() throws IOException {
        LearnerProgress progress = LearnerProgress.of("Ada")
                .movedTo(PLACES)
                .attempted(PLACES, false)
                .attempted(PLACES, true)
                .hinted(PLACES)
                .spent(PLACES, 1500);

        learners.keep(progress);

        assertThat(learners.open("Ada").progress()).isEqualTo(progress);
        assertThat(learners.names()).containsExactly("Ada");
        assertThat(progress.on(PLACES)).isEqualTo(new StepProgress(true, 2, false, 1, false, 1500));
    }

    @Test
    void severalLearnersHaveFilesOfTheirOwn() throws IOException {
        learners.keep(LearnerProgress.of("Ada").read(PLACES));
        learners.keep(LearnerProgress.of("Björn"));

        assertThat(learners.names()).containsExactly("Ada", "Björn");
        assertThat(learners.open("Björn").progress().on(PLACES)).isEqualTo(StepProgress.NONE);
        assertThat(learners.all().orThrow()).hasSize(2);
    }

    @Test
    void aBrokenFileIsSetAsideAndNamedAndNothingOfItIsLost() throws IOException {
        learners.keep(LearnerProgress.of("Ada").read(PLACES));
        Path file = folder.resolve("learners/Ada/progress.json");
        String broken = Files.readString(file).replace("\"done\" : true", "\"done\" : tru");
        Files.writeString(file, broken);

        Learners.Opened opened = learners.open("Ada");

        assertThat(opened.progress()).isEqualTo(LearnerProgress.of("Ada"));
        assertThat(Files.readString(opened.setAside().orElseThrow())).isEqualTo(broken);
        assertThat(opened.why()).contains("line 7");
    }

    @Test
    void aNameThatIsNoFolderIsRefused() {
        assertThatIOException()
                .isThrownBy(() -> learners.open("../Ada"))
                .withMessageContaining("cannot be the name of a learner");
    }

    @Test
    void whoHasNotBegunHasDoneNothing() throws IOException {
        assertThat(learners.names()).isEmpty();
        assertThat(learners.open("Ada").progress().at()).isEmpty();
    }
}

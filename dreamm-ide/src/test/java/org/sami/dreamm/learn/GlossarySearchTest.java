package org.sami.dreamm.learn;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.dreamm.learn.GlossarySearch.Found;
import org.sami.lessons.course.Course.StepAddress;

class GlossarySearchTest {
    private final GlossarySearch search = new GlossarySearch(LearnerScene.course());

    @Test
    void withoutWordsAllTermsAreThereInAlphabeticalOrder() {
        assertThat(search.find(" ")).extracting(Found::title).containsExactly("place", "token");
    }

    @Test
    void aTermComesBeforeWhatSpeaksOfItAndLeadsToWhereItIsExplained() {
        assertThat(search.find("PLACES"))
                .extracting(Found::title)
                .containsExactly("place", "token", "Places", "Mark", "Where", "How many");
        assertThat(search.find("places").get(0).step()).contains(new StepAddress("01-one", "places"));
        assertThat(search.find("places").get(0).where()).isEqualTo("Lesson 1: One");
    }

    @Test
    void whatNobodySaysIsNotFound() {
        assertThat(search.find("submarine")).isEmpty();
    }
}

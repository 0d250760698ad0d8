package org.sami.lessons.course;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class GlossaryTest {
    private final Glossary glossary = Glossary.read(CourseFiles.SHIPPED).orThrow();

    private List<String> terms(String text) {
        return glossary.mentions(text).stream().map(each -> each.term().id()).toList();
    }

    @Test
    void theTermsOfATextAreFoundInItsOrder() {
        assertThat(terms("Place \"Arrived\" has no edge to a transition"))
                .containsExactly("place", "edge", "transition");
    }

    @Test
    void theLongerOfTwoTermsCounts() {
        assertThat(terms("an output event of the start place")).containsExactly("output-event", "start-place");
    }

    @Test
    void aTermIsAWholeWord() {
        assertThat(terms("replace the placeholder")).isEmpty();
    }

    @Test
    void capitalsAndOtherFormsAreTheSameTerm() {
        assertThat(terms("Places")).containsExactly("place");
    }

    @Test
    void aMentionSaysWhereItStands() {
        assertThat(glossary.mentions("No place here"))
                .singleElement()
                .matches(each -> each.from() == 3 && each.to() == 8);
    }

    @Test
    void eachTermOfTheCourseIsExplainedInALesson() {
        assertThat(glossary.terms())
                .isNotEmpty()
                .allSatisfy(term -> assertThat(glossary.explainedIn(term)).isPresent());
    }
}

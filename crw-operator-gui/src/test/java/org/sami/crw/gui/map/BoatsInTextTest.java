package org.sami.crw.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class BoatsInTextTest {
    private static final List<String> FLEET = List.of("boat1", "boat10", "anna", "anna-2", "q.1");

    @Test
    void aBoatIsNamedByItsWholeName() {
        assertThat(BoatsInText.of("boat10 may not come home from the end of its way", FLEET))
                .containsExactly("boat10");
        assertThat(BoatsInText.of("anna-2 is to go 9.4 km. Send it?", FLEET)).containsExactly("anna-2");
        assertThat(BoatsInText.of("Susanna is no boat, q21 neither", FLEET)).isEmpty();
    }

    @Test
    void signsOfTheSentenceAreNoPartOfAName() {
        assertThat(BoatsInText.of("Send anna, boat1 (q.1)?", FLEET)).containsExactly("anna", "boat1", "q.1");
    }
}

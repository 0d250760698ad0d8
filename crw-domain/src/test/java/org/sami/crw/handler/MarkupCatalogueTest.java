package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** The vocabulary's markups against their source and against what is built: no option that does nothing. */
class MarkupCatalogueTest {
    /** Appendix .2.3, in its order. */
    private static final List<String> APPENDIX = List.of(
            "Attention",
            "DefaultSelection",
            "Description",
            "Filter",
            "Keyword",
            "MixedInitiativeTrigger",
            "SelectionOptions",
            "Optimize",
            "PhaseBranch",
            "PhaseItem",
            "Priority",
            "ProxyStatus",
            "RelevantArea",
            "RelevantInformation",
            "RelevantProxy",
            "Sort");

    /** Thesis 5.3. */
    private static final List<String> META = List.of("ManipulationFrequency", "ManipulationComponent");

    private final MarkupCatalogue catalogue = MarkupCatalogue.whole();

    @Test
    void theVocabularyHasEveryMarkupOfTheThesis() {
        assertThat(TestWorld.VOCABULARY.markups().keySet())
                .containsAll(APPENDIX)
                .containsAll(META);
    }

    @Test
    void everyOptionHasARow() {
        assertThat(catalogue.rows().keySet()).containsExactlyInAnyOrderElementsOf(MarkupCatalogue.declared());
    }

    @TestFactory
    Stream<DynamicTest> everyOptionActs() {
        return catalogue.rows().values().stream()
                .map(row -> DynamicTest.dynamicTest(
                        row.option() + ": " + row.effect(), () -> row.check().run()));
    }
}

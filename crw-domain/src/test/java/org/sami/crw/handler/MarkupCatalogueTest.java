package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
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

    /** Options without a row; a row that is added leaves this list, which gets shorter only. */
    private static final List<String> NOT_YET = List.of(
            "Attention.type=HIGHLIGHT",
            "Attention.type=BLINK",
            "Attention.end=ON_CLICK",
            "Attention.target=COMPONENT",
            "Attention.target=ALL_PROXIES",
            "Attention.target=RELEVANT_PROXIES",
            "DefaultLocation.location=QUAY",
            "DefaultLocation.location=AREA",
            "DefaultSelection.selection=ALL",
            "DefaultSelection.selection=NONE",
            "Description.source",
            "Description.showPlanName",
            "Description.showVertexName",
            "Description.showEventName",
            "Filter.source",
            "Filter.action=INCLUDE",
            "Filter.action=EXCLUDE",
            "SelectionOptions.number",
            "SelectionOptions.format=SEQUENTIAL",
            "SelectionOptions.format=STACKED",
            "SelectionOptions.format=TABS",
            "Optimize.criteria=COMPUTATION_TIME",
            "Optimize.criteria=EXECUTION_TIME",
            "Optimize.criteria=EXECUTION_SAFETY",
            "Optimize.criteria=EXECUTION_EFFICIENCY",
            "PhaseBranch.actionName",
            "PhaseBranch.phaseName",
            "PhaseBranch.actor=OPERATOR",
            "PhaseBranch.actor=SAMI",
            "PhaseBranch.actor=PROXY",
            "PhaseBranch.actor=TASK",
            "PhaseItem.phaseName",
            "PhaseItem.actor=OPERATOR",
            "PhaseItem.actor=SAMI",
            "PhaseItem.actor=PROXY",
            "PhaseItem.actor=TASK",
            "Sort.method=ALPHABETICAL",
            "Sort.method=CHRONOLOGICAL",
            "Sort.order=INCREASING",
            "Sort.order=DECREASING");

    private final MarkupCatalogue catalogue = MarkupCatalogue.whole();

    @Test
    void theVocabularyHasEveryMarkupOfTheThesis() {
        assertThat(TestWorld.VOCABULARY.markups().keySet())
                .containsAll(APPENDIX)
                .containsAll(META);
    }

    @Test
    void everyOptionHasARow() {
        Set<String> without = new LinkedHashSet<>(MarkupCatalogue.declared());
        without.removeAll(catalogue.rows().keySet());

        assertThat(without).as("options without a row").containsExactlyInAnyOrderElementsOf(NOT_YET);
    }

    @TestFactory
    Stream<DynamicTest> everyOptionActs() {
        return catalogue.rows().values().stream()
                .map(row -> DynamicTest.dynamicTest(
                        row.option() + ": " + row.effect(), () -> row.check().run()));
    }
}

package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.finding.Finding;
import org.sami.spn.legacy.CountedKind;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.Value;

class LegacyMarkupImportTest extends LegacyImportFixture {
    @Test
    void markupsKeepWhatTheyChoose() {
        OutputEventSpec message = outputOf(output(
                "crw.event.output.ui.DisplayMessage",
                "'fieldValues': {'message': {'type': 'string', 'value': 'Hello'}}, 'markups': ["
                        + "{'class': 'sami.markup.RelevantProxy', 'options': {'proxies': 'ALL_PROXIES', 'showPaths':"
                        + "'YES'}, 'parameters': {}},"
                        + "{'class': 'sami.markup.Keyword', 'options': {'text': 'SPECIFY'}, 'parameters': {'textOption':"
                        + "{'type': 'option', 'class': 'o', 'text': 'SK'}}},"
                        + "{'class': 'sami.markup.RelevantProxy', 'options': {}, 'parameters': {}},"
                        + "{'class': 'sami.markup.NeverHeardOf', 'options': {}, 'parameters': {}}]"));

        assertThat(message.markups())
                .extracting(m -> m.type() + m.options())
                .satisfiesExactly(
                        m -> assertThat(m).contains("ALL_PROXIES").contains("showPath=BooleanValue[value=true]"),
                        m -> assertThat(m).contains("SK"),
                        m -> assertThat(m).contains("RELEVANT_PROXIES"));
        assertThat(result().explained().of(CountedKind.MARKUPS)).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "SortOptions | 'sortOrderEnum': 'ALPHABETICAL' | | method=ALPHABETICAL",
                "SortOptions | 'sortOrderEnum': 'CREATION_TIME' | | method=CHRONOLOGICAL",
                "SortOptions | 'sortMethodEnum': 'CHRONOLOGICAL', 'sortOrderEnum': 'DECREASING' | | method=CHRONOLOGICAL order=DECREASING",
                "Sort | 'method': 'Alphabetical', 'order': 'DESCENDING' | | method=ALPHABETICAL order=DECREASING",
                "Sort | 'sortMethod': 'ALPHABETICAL', 'increasing': false | | method=ALPHABETICAL order=DECREASING",
                "ProxyStatus | 'proxyStatus': 'SEVERE' | | status=SEVERE",
                "ProxyStatus | 'proxyStatusEnum': 'WARNING' | | status=WARNING",
                "ProxyStatus | 'status': 'NOMINAL' | | status=NOMINAL",
                "FilterOptions | 'filterMethodEnum': 'TEXT', 'includeMatchEnum': 'EXCLUDE' | 'textOption': {'type': 'option', 'text': 'SHORE'} | action=EXCLUDE source=SHORE",
                "FilterOptions | 'includeMatch': true | 'text': {'type': 'string', 'value': 'SHORE'} | action=INCLUDE source=SHORE",
                "Filter | 'exclude': true | 'textOption': {'type': 'option', 'text': 'SHORE'} | action=EXCLUDE source=SHORE",
                "Description | 'textSourceEnum': 'SPECIFY', 'showPlanNameEnum': 'YES', 'showVertexNameEnum': 'NO', 'showEventName': true | 'textOption': {'type': 'option', 'text': 'Go?'} | showEventName=true showPlanName=true showVertexName=false source=Go?",
                "Keyword | 'textSource': 'SPECIFY' | 'textOption': {'type': 'option', 'text': 'SK'} | source=SK",
                "Attention | 'attentionTypeEnum': 'BLINK', 'attentionEnd': 'ON_CLICK', 'attentionTarget': 'FRAME' | 'blink': {'type': 'option', 'cycleLength': 2000} | end=ON_CLICK target=COMPONENT type=BLINK",
                "DefaultSelection | 'selectionEnum': 'NONE' | | selection=NONE",
                "MixedInitiativeTrigger | 'trigger': 'TIMEOUT' | 'timeoutOption': {'type': 'option', 'timeout': 30} | timeout=30 s trigger=TIMER",
                "NumberOfOptions | 'number': 'SPECIFY', 'formatEnum': 'TABBED' | 'numberOption': {'type': 'option', 'number': 3} | format=TABS number=3",
                "SelectionOptions | 'number': 4, 'format': 'STACKED' | | format=STACKED number=4",
                "Optimize | 'criteriaEnum': 'EXECUTION_SAFETY' | | criteria=EXECUTION_SAFETY",
                "PhaseItem | 'phaseNameSourceEnum': 'SPECIFY', 'actorEnum': 'OPERATOR' | 'textOption': {'type': 'option', 'text': 'Search'} | actor=OPERATOR phaseName=Search",
                "PhaseBranch | 'actor': 'PROXY' | 'actionName': {'type': 'string', 'value': 'Turn'} | actionName=Turn actor=PROXY",
                "Priority | 'rankingEnum': 'CRITICAL' | | rank=CRITICAL",
                "Priority | 'rank': 'Low' | | rank=LOW",
                "RelevantArea | 'areaSelectionEnum': 'ALL_PROXIES', 'viewModification': 'EXPAND', 'mapTypeEnum': 'POLITICAL' | | mapType=POLITICAL modification=EXPAND source=ALL_PROXIES",
                "RelevantInformation | 'information': 'temperature', 'visualizationEnum': 'CONTOUR' | | source=temperature visualization=CONTOUR",
                "RelevantProxy | 'proxiesEnum': 'ALL_PROXIES', 'showPathsEnum': 'YES', 'showDiagnostic': true, 'showDataEnum': 'NO' | | proxy=ALL_PROXIES showData=false showDiagnostic=true showPath=true",
            })
    void everyOptionOfAMarkupArrivesHoweverItsFieldIsSpelled(
            String markup, String options, String parameters, String expected) {
        OutputEventSpec message = outputOf(withMarkup(markup, options, parameters == null ? "" : parameters));

        assertThat(message.markups()).hasSize(1);
        assertThat(message.markups().get(0).options().entrySet().stream()
                        .map(o -> o.getKey() + "=" + inWords(o.getValue()))
                        .sorted())
                .containsExactly(expected.split(" (?=[a-zA-Z]+=)"));
        assertThat(result().isComplete()).isTrue();
    }

    private static String inWords(Value value) {
        if (value instanceof EnumValue word) {
            return word.constant();
        }
        if (value instanceof DurationValue duration) {
            return duration.millis() / 1000 + " s";
        }
        String text = value.toString();
        return text.substring(text.indexOf('=') + 1, text.length() - 1);
    }

    private static String withMarkup(String markup, String options, String parameters) {
        return output(
                "crw.event.output.ui.DisplayMessage",
                "'fieldValues': {'message': {'type': 'string', 'value': 'Hello'}}, 'markups': [{'class': 'sami.markup."
                        + markup + "', 'options': {" + options + "}, 'parameters': {" + parameters + "}}]");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Priority | 'ranking': 'UNHEARD_OF', 'rank': 'LOW' | W-UNKNOWN-OPTION",
                "Priority | 'ranking': 'HIGH', 'colour': 'RED' | W-UNKNOWN-OPTION",
                "Keyword | 'textSourceEnum': 'SPECIFY' | W-UNKNOWN-MARKUP",
                "NeverHeardOf | 'a': 'B' | W-UNKNOWN-MARKUP",
            })
    void anImportThatLostAnOptionOrAMarkupIsNotComplete(String markup, String options, String code) {
        document.plan("p1", "One").place("start", withMarkup(markup, options, ""));

        LegacyImport.Result result = result();

        assertThat(result.losses()).extracting(Finding::code).containsExactly(code);
        assertThat(result.isComplete()).isFalse();
    }
}

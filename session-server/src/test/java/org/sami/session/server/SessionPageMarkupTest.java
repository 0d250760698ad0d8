package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.model.Project;

/** What markups of a plan do on the page of a phone. */
@Tag("long")
@Timeout(900)
class SessionPageMarkupTest {
    private static final Project PROJECT = ServedPage.project("""
        {'formatVersion': 1, 'id': 'lake', 'name': 'Lake', 'domain': 'crw',
         'missionTree': [{'label': 'All', 'children': [{'plan': 'weed'}]}],
         'plans': [
          {'id': 'weed', 'name': 'Weed', 'places': [
            {'id': 'ask', 'name': 'Judge the weed', 'start': true, 'outputs': [
              {'id': 'weed', 'type': 'DisplayMessage', 'fields': {'message': {'value': 'Weed ahead'}},
               'markups': [{'type': 'Keyword', 'options': {'source': 'plants'}}]},
              {'id': 'wind', 'type': 'DisplayMessage', 'fields': {'message': {'value': 'Wind from the west'}},
               'markups': [{'type': 'Keyword', 'options': {'source': 'weather'}}]},
              {'id': 'approve', 'type': 'OperatorApprove', 'fields': {'question': {'value': 'Go on through the weed?'}},
               'markups': [
                 {'type': 'Attention', 'options': {'type': 'BLINK', 'target': 'COMPONENT'}},
                 {'type': 'PhaseItem', 'options': {'phaseName': 'Look', 'actor': 'OPERATOR'}},
                 {'type': 'MixedInitiativeTrigger', 'options': {'trigger': 'TIMER', 'timeout': 'PT2H'}}]}]},
            {'id': 'end', 'name': 'End', 'end': true},
            {'id': 'count', 'name': 'Count the boats', 'outputs': [
              {'id': 'home', 'type': 'OperatorApprove', 'fields': {'question': {'value': 'Are all boats home?'}},
               'markups': [{'type': 'PhaseItem', 'options': {'phaseName': 'Return', 'actor': 'OPERATOR'}}]}]}],
           'transitions': [
            {'id': 'yes', 'name': 'Yes', 'inputs': [{'id': 'said-yes', 'type': 'YesOption'}]},
            {'id': 'counted', 'name': 'Counted', 'inputs': [{'id': 'said-home', 'type': 'YesOption'}]},
            {'id': 'no', 'name': 'No', 'inputs': [{'id': 'said-no', 'type': 'NoOption'}]}],
           'inEdges': [
            {'id': 'i1', 'place': 'ask', 'transition': 'yes', 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'generic'}]},
            {'id': 'i2', 'place': 'ask', 'transition': 'no', 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'generic'}]},
            {'id': 'i3', 'place': 'count', 'transition': 'counted', 'requirements': [{'match': 'at-least', 'n': 1, 'kind': 'generic'}]}],
           'outEdges': [
            {'id': 'o1', 'transition': 'yes', 'place': 'count', 'requirements': [{'action': 'take', 'n': 1, 'kind': 'generic'}]},
            {'id': 'o3', 'transition': 'counted', 'place': 'end', 'requirements': [{'action': 'take', 'n': 1, 'kind': 'generic'}]},
            {'id': 'o2', 'transition': 'no', 'place': 'end', 'requirements': [{'action': 'take', 'n': 1, 'kind': 'generic'}]}]}
         ]}\
        """);

    @TempDir
    private Path folder;

    private ServedPage page;
    private TestBrowser browser;

    @BeforeEach
    void startTheMission() throws Exception {
        page = new ServedPage(PROJECT, folder);
        browser = page.browser;
        page.join();
        page.start("weed");
        browser.until("document.querySelector('#panel button.row') !== null");
    }

    @AfterEach
    void end() throws Exception {
        if (page != null) {
            page.close();
        }
    }

    private boolean is(String expression) throws Exception {
        return browser.value(expression).asBoolean();
    }

    @Test
    void decisionDrawsAttentionUntilItIsOpened() throws Exception {
        assertThat(is("document.querySelector('#panel button.row').classList.contains('blink')"))
                .isTrue();

        browser.click("#panel button.row");
        browser.until("document.querySelector('.decision') !== null");
        browser.click(".decision .back");

        browser.until("document.querySelector('#panel button.row') !== null");
        assertThat(is("document.querySelector('#panel button.row').classList.contains('blink')"))
                .isFalse();
    }

    @Test
    void stoppedTimerLeavesTheDecisionToThePerson() throws Exception {
        browser.click("#panel button.row");
        browser.until("document.querySelector('.decision .timer').textContent.startsWith('In ')");

        browser.click(".decision .timer button");

        browser.until("document.querySelector('.decision .timer').textContent === ''");
        assertThat(page.session.models().decisions().pending().get(0).decision().deadlineMillis())
                .isEmpty();
        browser.click(".decision .answers button.main");
        browser.until("document.querySelector('.decision') === null");
    }

    @Test
    void messagesOfOneKeywordAreShownAlone() throws Exception {
        browser.click("#tabs button:nth-child(4)");
        browser.until("document.querySelectorAll('#panel div.row').length === 2");

        browser.value(
                "[...document.querySelectorAll('.chips button')].find(one => one.textContent === 'weather').click()");

        browser.until("document.querySelectorAll('#panel div.row').length === 1");
        assertThat(browser.value("document.querySelector('#panel div.row').textContent")
                        .asText())
                .contains("Wind from the west");
    }

    @Test
    void missionShowsItsPhasesAndWhatIsUnderWay() throws Exception {
        browser.click("#tabs button:nth-child(3)");
        browser.until("document.querySelectorAll('.phases > li').length === 2");
        assertThat(browser.value("document.querySelector('.phases > li.active').textContent")
                        .asText())
                .isEqualTo("▶Look0 of 1▶Judge the weedOperator");
        browser.click("#tabs button:nth-child(1)");
        browser.click("#panel button.row");
        browser.click(".decision .answers button.main");
        browser.until("document.querySelector('.decision') === null");

        browser.click("#tabs button:nth-child(3)");

        browser.until("document.querySelector('.phases > li.done') !== null"
                + " && document.querySelector('.phases > li.active') !== null");
        assertThat(browser.value("document.querySelector('.phases > li.done').textContent")
                        .asText())
                .isEqualTo("✓Look1 of 1");
        assertThat(browser.value("document.querySelector('.phases > li.active').textContent")
                        .asText())
                .contains("Count the boats");
    }
}

package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.model.Project;

/** Somebody in a browser answers a question that another person answers as well, or that changes meanwhile. */
@Tag("long")
@Timeout(900)
class SessionPageSecondAnswerTest {
    private static final Project PROJECT = ServedPage.project("""
        {'formatVersion': 1, 'id': 'asking', 'name': 'Asking', 'domain': 'crw', 'plans': [{'id': 'asking', 'name': 'Asking',
         'places': [
          {'id': 'ask', 'start': true, 'outputs': [{'id': 'approve', 'type': 'OperatorApprove',
           'fields': {'question': {'value': 'Go on?'}}}]},
          {'id': 'done', 'end': true}],
         'transitions': [{'id': 'yes', 'inputs': [{'id': 'said-yes', 'type': 'YesOption'}]},
          {'id': 'no', 'inputs': [{'id': 'said-no', 'type': 'NoOption'}]}],
         'inEdges': [
          {'id': 'i1', 'place': 'ask', 'transition': 'yes', 'requirements': [{'kind': 'generic', 'match': 'at-least', 'n': 1}]},
          {'id': 'i2', 'place': 'ask', 'transition': 'no', 'requirements': [{'kind': 'generic', 'match': 'at-least', 'n': 1}]}],
         'outEdges': [
          {'id': 'o1', 'transition': 'yes', 'place': 'done', 'requirements': [{'kind': 'generic', 'action': 'take', 'n': 1}]},
          {'id': 'o2', 'transition': 'no', 'place': 'done', 'requirements': [{'kind': 'generic', 'action': 'take', 'n': 1}]}]}]}\
        """);

    /**
     * The page hears rows and news later while {@code window.late} is a list, as over a slow link; replies come at once unless
     * {@code window.slow} is another pattern.
     */
    private static final String SLOW_LINK = """
        (() => {
          const handler = Object.getOwnPropertyDescriptor(WebSocket.prototype, 'onmessage');
          Object.defineProperty(WebSocket.prototype, 'onmessage', {set(hear) {
            handler.set.call(this, (event) =>
              window.late && (window.slow ?? /"t":"(rows|news)"/).test(event.data)
                ? window.late.push({text: event.data, hear: () => hear(event)}) : hear(event));
          }});
        })()\
        """;

    @TempDir
    private Path folder;

    private ServedPage page;
    private TestBrowser browser;

    @BeforeEach
    void openTheQuestion() throws Exception {
        page = new ServedPage(PROJECT, folder);
        browser = page.browser;
        browser.value(SLOW_LINK);
        page.join();
        page.start("asking");
        browser.click("#panel button.row");
        browser.until("document.querySelector('.decision .answers button') !== null");
    }

    @AfterEach
    void end() throws Exception {
        if (page != null) {
            page.close();
        }
    }

    @Test
    void personIsToldWhoAnsweredWhileTheQuestionWasOpen() throws Exception {
        answerAsBen();

        browser.until("document.querySelector('.decision') === null");
        browser.until("document.getElementById('notice').textContent.includes('ben answered [')");
    }

    @Test
    void personWhoAnswersSecondIsToldWhoWasFirst() throws Exception {
        browser.value("window.late = []");
        answerAsBen();

        browser.click(".decision .answers button:not(.main)"); // No

        browser.until("document.querySelector('.decision').textContent.includes('ben has answered decision ')");
        hearWhatIsLate();
        browser.until("document.querySelector('.decision') === null");
        browser.until("document.getElementById('notice').textContent.includes('ben answered [')");
        assertThat(page.session.models().decisions().pending()).isEmpty();
    }

    @Test
    void lateReplyToOneAnswerLeavesTheFormOfAnotherQuestionOpen() throws Exception {
        page.start("asking");
        browser.until("document.querySelectorAll('#panel button.row').length === 2");
        browser.click("#panel button.row");
        browser.value("window.slow = /\"t\":\"(rows|news|done)\"/; window.late = []");
        browser.click(".decision .answers button:not(.main)"); // No
        browser.click(".decision button.back");
        browser.click("#panel button.row:nth-child(2)");
        browser.until("document.querySelector('.decision .answers button') !== null");
        browser.value("window.second = document.querySelector('.decision')");

        browser.until("window.late.some((one) => one.text.includes('\"t\":\"done\"'))");
        hearWhatIsLate();

        assertThat(browser.value("document.querySelector('.decision') === window.second")
                        .asBoolean())
                .isTrue();
    }

    @Test
    void openQuestionHasButtonsWhileItIsThePersons() throws Exception {
        Path people = folder.resolve("people");
        String operators = Files.readString(people);

        Files.writeString(people, operators.replace("operator", "observer"));
        browser.until("document.querySelector('.decision > .hint')?.textContent.includes('observer')");
        assertThat(browser.value("document.querySelector('.decision .answers button') === null")
                        .asBoolean())
                .isTrue();

        Files.writeString(people, operators);
        browser.until("document.querySelector('.decision .answers button.main') !== null");
    }

    private void hearWhatIsLate() {
        browser.value("const heard = window.late; window.late = null; heard.forEach((one) => one.hear())");
    }

    private void answerAsBen() throws Exception {
        TestFront ben = TestFront.loggedIn(page.server, "ben", "key of ben");
        JsonNode asked = ben.decision();
        ben.send("{\"t\":\"answer\",\"id\":1,\"decision\":" + asked.path("id") + ",\"answer\":{\"yes\":true}}");
        assertThat(ben.reply(1).path("t").asText()).isEqualTo("done");
    }
}

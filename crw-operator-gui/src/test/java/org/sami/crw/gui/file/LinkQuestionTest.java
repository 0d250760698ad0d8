package org.sami.crw.gui.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.session.api.LinkedBoat;
import org.sami.session.api.RefusedException;

/** How often a session is asked which boats it has links to. */
class LinkQuestionTest {
    private static final LinkedBoat ANNA = new LinkedBoat("anna", BoatAddress.parse("127.0.0.1:11411"));

    private final List<CompletableFuture<List<LinkedBoat>>> asked = new ArrayList<>();
    private final List<LinkedBoat> boats = new ArrayList<>();
    private final List<String> words = new ArrayList<>();
    private final LinkQuestion question = new LinkQuestion(this::ask, boats::addAll, words::add);

    private CompletableFuture<List<LinkedBoat>> ask() {
        CompletableFuture<List<LinkedBoat>> one = new CompletableFuture<>();
        asked.add(one);
        return one;
    }

    private void looks(int times) {
        for (int look = 0; look < times; look++) {
            question.look();
        }
    }

    @Test
    void isAskedAgainOnceItIsAnswered() {
        question.begin();
        asked.get(0).complete(List.of(ANNA));
        looks(1);

        assertThat(boats).containsExactly(ANNA);
        assertThat(asked).hasSize(2);
    }

    @Test
    void refusalIsSaidAndNothingMoreIsAsked() {
        question.begin();
        asked.get(0).completeExceptionally(new RefusedException("paul may not drive"));
        looks(30);

        assertThat(words).containsExactly("paul may not drive");
        assertThat(question.isRefused()).isTrue();
        assertThat(asked).hasSize(1);
    }

    @Test
    void refusalCountsUntilTheViewIsOpenedAnew() {
        question.begin();
        asked.get(0).completeExceptionally(new RefusedException("the connection is lost"));
        question.begin();
        asked.get(1).complete(List.of(ANNA));

        assertThat(boats).containsExactly(ANNA);
        assertThat(words).containsExactly("the connection is lost", "");
    }

    @Test
    void baseThatDoesNotKnowTheQuestionIsAskedOnceOnly() {
        question.begin();
        looks(30);

        assertThat(asked).hasSize(1);
        assertThat(words)
                .containsExactly(
                        "the session does not say which boats it has links to; bring its base to this version");
    }
}

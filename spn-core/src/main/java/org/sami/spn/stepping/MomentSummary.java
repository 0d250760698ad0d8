package org.sami.spn.stepping;

import java.util.List;
import java.util.stream.Collectors;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.engine.PendingAnswer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Token;

/**
 * A text that is equal for moments with the same tokens, kept answers and questions, without their order and values. Such moments may go on
 * differently; a run in which one text comes again and again goes round.
 */
final class MomentSummary {
    private MomentSummary() {}

    static String of(EngineView view, String tasks) {
        StringBuilder text = new StringBuilder(tasks);
        for (MissionView mission : view.missions()) {
            text.append('|').append(mission.plan()).append(mission.status());
            mission.marking().forEach((place, tokens) -> text.append(place).append(sorted(tokens)));
            text.append(view.pendingAnswers(mission.id()).stream()
                    .map(MomentSummary::words)
                    .sorted()
                    .collect(Collectors.joining(",")));
        }
        return text.append(
                        view.decisions().stream().map(Decision::type).sorted().toList())
                .toString();
    }

    private static String sorted(List<Token> tokens) {
        return tokens.stream().map(Token::toString).sorted().toList().toString();
    }

    private static String words(PendingAnswer pending) {
        return pending.occurrence().type()
                + pending.occurrence().proxies()
                + pending.occurrence().tasks();
    }
}

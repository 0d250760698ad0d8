package org.sami.spn.stepping;

import java.util.List;
import java.util.stream.Collectors;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.engine.PendingAnswer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Token;

/**
 * How a moment looks: what stands where, what is kept and what is asked, whatever the order and whatever the values. Moments that look alike
 * may go on differently; a run that looks alike again and again goes round.
 */
final class Looks {
    private Looks() {}

    static String of(EngineView view, String tasks) {
        StringBuilder looks = new StringBuilder(tasks);
        for (MissionView mission : view.missions()) {
            looks.append('|').append(mission.plan()).append(mission.status());
            mission.marking().forEach((place, tokens) -> looks.append(place).append(sorted(tokens)));
            looks.append(view.pendingAnswers(mission.id()).stream()
                    .map(Looks::words)
                    .sorted()
                    .collect(Collectors.joining(",")));
        }
        return looks.append(
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

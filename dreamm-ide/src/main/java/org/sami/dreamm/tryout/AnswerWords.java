package org.sami.dreamm.tryout;

import org.sami.spn.protocol.Answer;

/** What an operator answered, in words for people. */
final class AnswerWords {
    private AnswerWords() {}

    static String of(Answer answer) {
        if (answer instanceof Answer.YesNo a) {
            return a.yes() ? "yes" : "no";
        } else if (answer instanceof Answer.Proxies a) {
            return a.proxies().isEmpty() ? "nobody" : String.join(", ", a.proxies());
        } else if (answer instanceof Answer.Option a) {
            return "option " + (a.index() + 1);
        }
        return answer instanceof Answer.Fields a ? StepWords.values(a.values()) : "none of them";
    }
}

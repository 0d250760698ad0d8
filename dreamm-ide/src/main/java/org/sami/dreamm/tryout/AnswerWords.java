package org.sami.dreamm.tryout;

import org.sami.spn.protocol.Answer;
import org.sami.spn.stepping.StepText;

/** What an operator answered, in words for people. */
final class AnswerWords {
    private AnswerWords() {}

    static String of(Answer answer, StepText words) {
        if (answer instanceof Answer.YesNo a) {
            return a.yes() ? "yes" : "no";
        } else if (answer instanceof Answer.Proxies a) {
            return a.proxies().isEmpty() ? "nobody" : String.join(", ", a.proxies());
        } else if (answer instanceof Answer.Option a) {
            return "option " + (a.index() + 1);
        }
        return answer instanceof Answer.Fields a ? StepWords.values(a.values(), words) : "none of them";
    }
}

package org.sami.dreamm.query;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.planspace.PlanQueryAnswer.Result;

/**
 * What is known of a saved query.
 *
 * @param answer on the plan as it is now; empty where nobody has asked
 */
record QueryRow(PlanQuery query, Optional<PlanQueryAnswer> answer) {
    QueryRow {
        Objects.requireNonNull(query, "query");
        Objects.requireNonNull(answer, "answer");
    }

    String word() {
        return answer.map(given -> switch (given.result()) {
                    case EXPECTED -> "met";
                    case UNEXPECTED -> "NOT MET";
                    case OPEN -> given.mayBe() ? "not certain" : "open";
                    case FAULT -> "fault";
                })
                .orElse("not asked");
    }

    /** What came of it, or what it asks. */
    String words() {
        return answer.map(PlanQueryAnswer::words)
                .orElseGet(() -> query.text()
                        + (query.expected() == PlanQuery.Expected.YES ? " – expected: yes" : " – expected: no"));
    }

    boolean isBad() {
        return answer.filter(a -> a.result() == Result.UNEXPECTED || a.result() == Result.FAULT)
                .isPresent();
    }

    boolean isGood() {
        return answer.filter(a -> a.result() == Result.EXPECTED).isPresent();
    }
}

package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;

/** Random requirements, in the words of {@link org.sami.spn.testing.Requirements}. */
final class RandomRequirements {
    private static final String[] KINDS = {"proxy", "proxy", "proxy", "any", "any", "generic"};
    private static final String[] KINDS_OF_TASKS = {"task", "task", "task:T1", "task:Measure"};
    private static final String[] RELEVANT = {
        "relevant all", "relevant all", "relevant all", "relevant all", "relevant >= 1", "relevant >= 1",
        "relevant >= 1", "relevant >= 2", "relevant == 1", "relevant < 2", "relevant < 3", "relevant = 0"
    };
    private static final String[] OUT_SUB = {
        "take all sub",
        "take all sub",
        "take all sub",
        "take 1 sub",
        "consume all sub",
        "consume 1 sub",
        "add all sub",
        "add 1 sub"
    };

    private final Dice dice;
    private final boolean hasTasks;

    RandomRequirements(Dice dice, boolean hasTasks) {
        this.dice = dice;
        this.hasTasks = hasTasks;
    }

    String kind() {
        return dice.pick(dice.chance(hasTasks ? 45 : 3) ? KINDS_OF_TASKS : KINDS);
    }

    // ---- Of in edges

    /** One that tokens of that kind can meet. */
    String wanting(String kind) {
        return kind + dice.pick(" >= 1", " >= 1", " >= 1", " >= 1", " >= 2", " == 1", " == 2", " < 3", " < 4");
    }

    /** One that is met where nobody of that kind stands. */
    String inhibiting(String kind) {
        return kind + dice.pick(" = 0", " = 0", " = 0", " < 1", " < 2", " == 0");
    }

    String relevant() {
        return dice.pick(RELEVANT);
    }

    /** Whatever comes, also what nothing can meet. */
    String[] anyIn(boolean isNamed, boolean isSub) {
        List<String> requirements = new ArrayList<>();
        int count = dice.chance(90) ? 1 : 2;
        for (int i = 0; i < count; i++) {
            if (isNamed && dice.chance(40)) {
                requirements.add(relevant());
            } else if (dice.chance(isSub ? 50 : 15)) {
                requirements.add("always");
            } else {
                requirements.add(dice.chance(70) ? wanting(kind()) : inhibiting(kind()));
            }
        }
        return requirements.stream().distinct().toArray(String[]::new);
    }

    // ---- Of out edges

    /** One that moves, removes or copies tokens of that kind. */
    String moving(String kind) {
        String quantity = dice.pick("all", "all", "1", "1", "2");
        return dice.pick("take ", "take ", "take ", "take ", "consume ", "consume ", "add ", "add ") + quantity + " "
                + kind;
    }

    String movingRelevant() {
        return dice.pick("take ", "take ", "take ", "take ", "take ", "add ", "consume ")
                + dice.pick("all ", "all ", "all ", "1 ", "2 ")
                + "relevant";
    }

    String movingReturned() {
        return dice.pick(OUT_SUB);
    }

    /** Whatever comes. */
    String[] anyOut(boolean isNamed, boolean isFromSub) {
        List<String> requirements = new ArrayList<>();
        int count = dice.chance(70) ? 1 : 2;
        for (int i = 0; i < count; i++) {
            if (isFromSub && dice.chance(55)) {
                requirements.add(movingReturned());
            } else if (isNamed && dice.chance(55)) {
                requirements.add(movingRelevant());
            } else {
                requirements.add(dice.chance(6) ? "always" : moving(kind()));
            }
        }
        return requirements.stream().distinct().toArray(String[]::new);
    }
}

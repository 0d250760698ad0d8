package org.sami.crw.operator.alarm;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/**
 * The one count of alarms. Active alarms are counted apart from those that are over but not acknowledged.
 *
 * @param open active, not acknowledged
 * @param known active, acknowledged
 * @param over no longer active, not acknowledged
 */
public record AlarmCount(int open, int known, int over) {
    /** That of a list. */
    public static AlarmCount of(Collection<Alarm> alarms) {
        int open = 0;
        int known = 0;
        int over = 0;
        for (Alarm alarm : alarms) {
            if (!alarm.active()) {
                over++;
            } else if (alarm.acknowledged()) {
                known++;
            } else {
                open++;
            }
        }
        return new AlarmCount(open, known, over);
    }

    /** Such as {@code 2 alarms · 1 over}, {@code 1 known alarm} or {@code no alarms}. */
    public String words() {
        List<String> words = new ArrayList<>();
        if (open > 0) {
            words.add(open + (open == 1 ? " alarm" : " alarms"));
        }
        if (known > 0) {
            words.add(known + (open > 0 ? " known" : known == 1 ? " known alarm" : " known alarms"));
        }
        if (over > 0) {
            words.add(over + (words.isEmpty() ? over == 1 ? " alarm over" : " alarms over" : " over"));
        }
        return words.isEmpty() ? "no alarms" : String.join(" · ", words);
    }
}

package org.sami.house

import org.gradle.api.services.BuildService
import org.gradle.api.services.BuildServiceParameters

/**
 * A display of the build's own, with a window manager, for what opens real windows: Xvfb and openbox, where they are installed. It is begun by whom
 * first asks for it, and ends with the build.
 */
abstract class VirtualDisplay implements BuildService<BuildServiceParameters.None>, AutoCloseable {
    /** How to get what is missing. */
    static final String INSTALL = 'apt-get install -y --no-install-recommends xvfb xauth openbox'

    private static final String SCREEN = '1600x1000x24'

    private List<Process> processes = []
    private String name

    /** The display's name for the variable DISPLAY; empty text where Xvfb or openbox is not installed. */
    synchronized String name() {
        if (name == null) {
            name = isInstalled('Xvfb') && isInstalled('openbox') ? begin() : ''
        }
        return name
    }

    private static boolean isInstalled(String program) {
        (System.getenv('PATH') ?: '').split(File.pathSeparator).any { new File(it, program).canExecute() }
    }

    private String begin() {
        def xvfb = new ProcessBuilder('Xvfb', '-displayfd', '1', '-screen', '0', SCREEN, '-nolisten', 'tcp', '-r')
            .redirectError(ProcessBuilder.Redirect.DISCARD).start()
        processes << xvfb
        def number = new BufferedReader(new InputStreamReader(xvfb.inputStream)).readLine()
        if (number == null) {
            return ''
        }
        def display = ":${number.trim()}".toString()
        def openbox = new ProcessBuilder('openbox')
            .redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD)
        openbox.environment().put('DISPLAY', display)
        processes << openbox.start()
        return display
    }

    @Override
    void close() {
        processes.reverse().each { it.destroy() }
    }
}

package raytracing.report;

/** What a reader of the page must know. */
final class Texts {
    static final String TIME_AT_EQUAL_ERROR = """
        <p>A time says nothing without the error that it leaves, and the other way round. So methods are compared at the
        same error. Between two measured settings the time is read off the straight line between them on logarithmic
        axes; beyond the finest it is extrapolated by the power law that the finer half follows, and marked *. No error
        is known to be smaller than the reference's own: there, ≤ stands before it, and ≥ before what plain work needs
        for that. In a small picture many pixels lie at edges; the larger it is, the smaller is their share, and the
        more is gained by refining them alone.</p>
        <p>Recommended is the fastest setting, of those that an option asks for, that is right to half a step of 1/255
        (root mean square); of several that take about as long, the closest.</p>
        """;

    static final String HARD_SHADOWS = """
        <p>All shadows of this scene are hard: no light with shadows has a width, so one shadow ray says all, and
        exact shadows are the same picture.</p>
        """;

    static final String SPEED_UPS = """
        <p>Work that is skipped because it should change no bit of the picture. Each speed-up is left out in turn, and
        the films are compared bit by bit: how many pixels differ at most, and by how much at most in linear light.</p>
        """;

    static final String COLD = """
        <p>What users wait for: the virtual machine starts, reads the scene, draws with code that is not compiled yet,
        and packs the picture.</p>
        """;

    static final String CROSSINGS = """
        <p>The same question one level below: how often is each formula for the crossing of a ray and a surface wrong,
        and what does it cost? This part is not measured with the rest; it is the last result of
        <code>gradle numerics</code>, with a machine and a commit of its own.</p>
        """;

    static final String DEFINITIONS = """
        <dl>
        <dt>frame</dt><dd>A call of <code>render</code> in a virtual machine that has drawn the scene many times, with
        as many threads as processors. The settings take turns, round after round, so a disturbance hits all of
        them alike. Shown: the median, and the quartiles in brackets and as
        thin lines of the plots.</dd>
        <dt>noise</dt><dd>Quartiles farther apart than a fifth of the median, or more rays of the same kind (or a smaller
        error) in clearly less time. Such settings are drawn again; those that still look so are marked †.</dd>
        <dt>soft shadows</dt><dd>One ray a pixel; what is judged is the light at the point that it meets. The reference
        is the mean of two pictures with many more shadow rays and other random numbers than any setting's.</dd>
        <dt>edges</dt><dd>Exact shadows, and more rays at edges (<code>--samples n</code>), in every pixel, or as many as an
        error of E steps needs (<code>--error E</code>); what is judged is the mean light of the whole pixel. The
        reference is the mean of two pictures with n x n and (n - 1) x (n - 1) rays in every pixel, whose places hardly coincide.</dd>
        <dt>the reference's own error</dt><dd>The two halves of a reference err independently of each other, and about
        alike. So their difference is the square root of 2 times as large as the error of each, and the error of their
        mean is half their difference. A distance up to the square root of 2 times that says no more than that the
        picture is at least as good as the reference.</dd>
        <dt>RMSE</dt><dd>Root of the mean square error over all channels of all pixels, in linear light from 0 to 1;
        light above 1, full white, counts as 1, for that is what a picture shows of it.</dd>
        <dt>largest</dt><dd>The largest absolute error of a channel of a pixel, in linear light.</dd>
        <dt>PSNR</dt><dd>10 log10 (255<sup>2</sup> / mean square error) of the pictures in 8 bits a channel.</dd>
        <dt>off by &gt; 1 step</dt><dd>Share of the pixels of which a channel differs by more than one of the 255
        steps.</dd>
        <dt>SSIM</dt><dd>Mean structural similarity after Wang, Bovik, Sheikh and Simoncelli (Image Quality Assessment:
        From Error Visibility to Structural Similarity, IEEE Transactions on Image Processing 13, 2004): Gaussian window
        of 11 x 11 pixels with sigma 1.5, K1 = 0.01, K2 = 0.03, L = 255, on the luma of ITU-R BT.601 of the 8-bit
        pictures as they are shown. Only windows that lie wholly in the compared part count; nothing is scaled down.</dd>
        <dt>close-ups</dt><dd>The 32 x 32 pixels of each picture with the largest mean square error, framed in the picture:
        on the left the picture, on the right the reference. Where all scenes are drawn, one of eight squares of the
        picture has a reference, and the worst of these is shown.</dd>
        <dt>Pareto front</dt><dd>The settings that no other beats in both time and error. Who takes another gives
        something away.</dd>
        <dt>colours of the error maps</dt><dd>The cubehelix of Green (A colour scheme for the display of astronomical
        intensity images, Bulletin of the Astronomical Society of India 39, 2011), from its bright end: brightness alone
        tells the order.</dd>
        </dl>
        """;

    private Texts() {
    }
}
